// Reads a document's values into structs of plain data by the tables of their keys, and collects
// every problem found on the way.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "app/errors/nearest_name.hpp"
#include "app/tables/document.hpp"
#include "app/tables/table.hpp"
#include "render/frame_rate.hpp"

namespace spindrift::app {

/// A value as messages show it: "an object", or the value itself, shortened where it is long.
std::string found_text(const Json& json);

/// The accepted range of a field's numbers, and their unit for messages.
struct Bounds {
  Range range;
  std::string_view unit;
};

/// Reads values by their type and by the tables of their sections. A value that is not as it should
/// be adds a problem, and reading goes on.
class TableReader {
 public:
  std::vector<Problem> problems() && { return std::move(problems_); }

  /// Reads an object into a section. Keys that are absent leave their fields as they are.
  template <Section T>
  void read(const LocatedValue& value, T& into, const Bounds& = {}) {
    if constexpr (!lone_entry_name<T>.empty())
      return read_list_or_entry(value, into);
    std::vector<std::string_view> meant;
    if (!check_keys(value, keys_of<T>(), meant))
      return;
    read_fields(value, into, meant);
    if constexpr (Checked<T>)
      into.check([&](std::string_view key, std::string message) {
        complain(value.find(key).value_or(value), std::move(message));
      });
  }

 private:
  void complain(const LocatedValue& value, std::string message) {
    problems_.push_back(value.problem(std::move(message)));
  }

  /// Complains if the value is no object, or of each of its keys that is not among `keys`.
  /// @param meant receives the nearest names of the unknown keys, which need not be reported as
  /// missing as well
  /// @return whether the value is an object
  bool check_keys(const LocatedValue& value, const std::vector<std::string_view>& keys,
                  std::vector<std::string_view>& meant);

  template <Section T>
  void read_fields(const LocatedValue& value, T& into, const std::vector<std::string_view>& meant) {
    const auto is_meant = [&](std::string_view key) {
      return std::find(meant.begin(), meant.end(), key) != meant.end();
    };
    for_each_field<T>([&](const auto& field) {
      auto& member = into.*field.member;
      using Value = std::remove_reference_t<decltype(member)>;
      if (field.key.empty()) {
        if constexpr (Section<Value>) {
          read_fields(value, member, meant);
        } else if constexpr (Alternatives<Value>) {
          const auto& names = alternative_names<Value>;
          read_alternative(value, member, std::any_of(names.begin(), names.end(), is_meant));
        }
        return;
      }
      if (const auto found = value.find(field.key)) {
        read(*found, member, Bounds{field.range, field.unit});
      } else if (field.presence == Presence::required && !is_meant(field.key)) {
        complain(value, fmt::format("\"{}\" is missing ({})", field.key, field.about));
      }
    });
  }

  /// Reads the one alternative that the value has a key of.
  /// @param is_meant whether an unknown key is probably a misspelt alternative, which then need
  /// not be reported as missing
  template <Alternatives V>
  void read_alternative(const LocatedValue& value, V& into, bool is_meant) {
    const auto& names = alternative_names<V>;
    static_assert(!names.back().empty(), "every alternative of the variant needs a name");
    std::vector<std::size_t> given;
    for (std::size_t i = 0; i < names.size(); ++i)
      if (value.json().contains(names[i]))
        given.push_back(i);
    if (given.size() != 1) {
      if (!given.empty() || !is_meant)
        complain(value, fmt::format("expected one {} out of {}, found {}", variant_name<V>,
                                    fmt::join(names, ", "), given.size()));
      return;
    }
    into = all_alternatives<V>(std::make_index_sequence<std::variant_size_v<V>>())[given[0]];
    const LocatedValue chosen = *value.find(names[given[0]]);
    std::visit([&](auto& alternative) { read(chosen, alternative); }, into);
  }

  template <class V, std::size_t... I>
  static std::array<V, sizeof...(I)> all_alternatives(std::index_sequence<I...>) {
    return {V(std::in_place_index<I>)...};
  }

  /// Reads a section's list, or a single entry whose keys are written directly into the section.
  template <Section T>
  void read_list_or_entry(const LocatedValue& value, T& into) {
    const auto& field = std::get<0>(table<T>);
    auto& list = into.*field.member;
    std::vector<std::string_view> keys = keys_of<T>(), of_entry = keys_of<LoneEntry<T>>(), meant;
    keys.insert(keys.end(), of_entry.begin(), of_entry.end());
    if (!check_keys(value, keys, meant))
      return;
    const bool has_list = value.json().contains(field.key);
    const std::size_t known = value.json().size() - meant.size();
    if (has_list && known > 1) {
      complain(value, fmt::format("give either {} or {}, not both", field.key, lone_entry_name<T>));
    } else if (has_list) {
      read_fields(value, into, meant);
    } else if (known > 0) {
      list.resize(1);
      read_fields(value, list[0], meant);
    }
  }

  template <class T>
  void read(const LocatedValue& value, std::vector<T>& into, const Bounds& of_each) {
    if (!value.json().is_array())
      return complain(value,
                      fmt::format("expected a list [...], found {}", found_text(value.json())));
    into.clear();
    for (std::size_t i = 0; i < value.json().size(); ++i) {
      into.emplace_back();
      read(value[i], into.back(), of_each);
    }
  }

  template <class T>
  void read(const LocatedValue& value, NonEmpty<T>& into, const Bounds& of_each) {
    if (value.json().is_array() && !value.json().empty())
      return read(value, static_cast<std::vector<T>&>(into), of_each);
    complain(value, fmt::format("expected a list [...] of at least one entry, found {}",
                                found_text(value.json())));
  }

  template <class T>
  void read(const LocatedValue& value, std::vector<Keyed<T>>& into, const Bounds& of_each) {
    if (!value.json().is_object())
      return complain(
          value, fmt::format("expected an object {{...}}, found {}", found_text(value.json())));
    into.clear();
    value.for_each_member([&](const std::string& key, const LocatedValue& member) {
      into.push_back({key, {}, member.place_and_path()});
      read(member, into.back().value, of_each);
    });
  }

  template <class T>
  void read(const LocatedValue& value, Placed<T>& into, const Bounds& bounds) {
    into.place = value.place_and_path();
    read(value, into.value, bounds);
  }

  template <class T>
  void read(const LocatedValue& value, std::optional<T>& into, const Bounds& bounds) {
    read(value, into.emplace(), bounds);
  }

  /// Takes a value of any kind as it is.
  void read(const LocatedValue& value, Json& into, const Bounds&) { into = value.json(); }

  /// Reads a name or a file's name; control characters, line ends among them, are refused.
  void read(const LocatedValue& value, std::string& into, const Bounds&);

  void read(const LocatedValue& value, bool& into, const Bounds&);

  /// A number within the bounds; none, and a problem, for anything else.
  std::optional<double> read_number(const LocatedValue& value, const Bounds& bounds);

  void read(const LocatedValue& value, double& into, const Bounds& bounds);
  void read(const LocatedValue& value, float& into, const Bounds& bounds);
  void read(const LocatedValue& value, int& into, const Bounds& bounds);

  void read(const LocatedValue& value, FrameRate& into, const Bounds& bounds);

  void read(const LocatedValue& value, glm::vec3& into, const Bounds& bounds);

  template <class E>
  requires std::is_enum_v<E>
  void read(const LocatedValue& value, E& into, const Bounds&) {
    const auto& names = value_names<E>;
    const std::string found = found_text(value.json());
    if (!value.json().is_string())
      return complain(value,
                      fmt::format("expected one of {}, found {}", fmt::join(names, ", "), found));
    const auto typed = value.json().get<std::string>();
    const auto at = std::find(names.begin(), names.end(), typed);
    if (at == names.end())
      return complain(value, fmt::format("unknown value {}; {}", found, suggestion(typed, names)));
    into = static_cast<E>(at - names.begin());
  }

  // Exists only so that read_fields compiles: alternatives are read through their owner's keys.
  template <Alternatives V>
  void read(const LocatedValue&, V&, const Bounds&) {}

  std::vector<Problem> problems_;
};

/// Reads the whole document into a section.
/// @throws SceneError with every problem in the document
template <Section T>
void read_document(const SceneDocument& document, T& into) {
  TableReader reader;
  reader.read(document.value(), into);
  throw_if_any(std::move(reader).problems());
}

}  // namespace spindrift::app
