// Tables of the keys of a JSON file, one for each struct of plain data (a section). The reader, the
// writer and the JSON schema of a section all work from its table.
#pragma once

#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "sim/geometry/keys.hpp"

namespace spindrift::app {

/// The type of table<T> where T has no table.
struct NoTable {};
/// The tuple of the Fields of a section. It is the struct's own static member `fields` where there
/// is one, and is specialised for other structs.
template <class T>
inline constexpr NoTable table{};
template <class T>
requires requires {
  T::fields;
}
inline constexpr auto table<T> = T::fields;

/// A struct that has a table of its keys.
template <class T>
concept Section = !std::is_same_v<decltype(table<T>), const NoTable>;

/// Calls f with every field of a section's table, in order.
template <Section T, class F>
void for_each_field(F&& f) {
  std::apply([&](const auto&... field) { (f(field), ...); }, table<T>);
}

/// Whether T is a std::optional: a value that may be left out, and that is then left out of the
/// resolved scene as well.
template <class T>
inline constexpr bool is_optional = false;
template <class T>
inline constexpr bool is_optional<std::optional<T>> = true;

/// The range of numbers of which each is accepted.
inline constexpr Range any_number{-std::numeric_limits<double>::infinity(),
                                  std::numeric_limits<double>::infinity()};

/// A member of an object whose keys a file chooses freely, as in {"fluid.viscosity": 0.1}. A list
/// of these is such an object, with its members in the order of the file.
template <class T>
struct Keyed {
  std::string key;
  T value;
  std::string place = {};  ///< where it was written, as in "sweep.json:3:5: set.fluid.viscosity"
};

/// A value and where it was written.
template <class T>
struct Placed {
  T value;
  std::string place;  ///< as in "sweep.json:3:5: grid.fluid.viscosity[0]"
};

/// A list that must not be empty in a file.
template <class T>
struct NonEmpty : std::vector<T> {
  using std::vector<T>::vector;
};

/// Reports a problem with the value of one of a section's keys; with the section where it has no
/// such key.
using Complain = std::function<void(std::string_view key, std::string message)>;

/// A section with values that must fit each other. Its check() reports those that do not. Values
/// that could not be read have their defaults then.
template <class T>
concept Checked = requires(const T& section, const Complain& complain) {
  section.check(complain);
};

/// For a section whose only field is a list, and into which the keys of a single entry may be
/// written directly: the name of such an entry in messages, as "a still camera" for a list of
/// camera keyframes. Empty for all other types.
template <class T>
inline constexpr std::string_view lone_entry_name{};
/// The type of such an entry.
template <Section T>
using LoneEntry = typename std::remove_cvref_t<decltype(std::declval<T&>().*
                                                        std::get<0>(table<T>).member)>::value_type;

/// The names of an enumeration's values in files, in the order of the values, which count from 0.
template <class E>
inline constexpr std::array<std::string_view, 0> value_names{};

/// What a variant is called in messages.
template <class V>
inline constexpr std::string_view variant_name{};
/// The keys of a variant's alternatives, in the order of the alternatives: each alternative's own
/// static member `name`, or as specialised.
template <class V>
inline constexpr std::array<std::string_view, 0> alternative_names{};
template <class... S>
requires(requires { S::name; } && ...) inline constexpr std::array<
    std::string_view, sizeof...(S)> alternative_names<std::variant<S...>>{S::name...};
/// A variant of which a file gives exactly one alternative, by its key.
template <class V>
concept Alternatives = !variant_name<V>.empty();

/// The keys of a section in a file, those of its fields with empty keys included.
template <Section T>
std::vector<std::string_view> keys_of() {
  std::vector<std::string_view> keys;
  for_each_field<T>([&](const auto& field) {
    using Value = std::remove_cvref_t<decltype(std::declval<T&>().*field.member)>;
    if (!field.key.empty()) {
      keys.push_back(field.key);
    } else if constexpr (Section<Value>) {
      const auto its_own = keys_of<Value>();
      keys.insert(keys.end(), its_own.begin(), its_own.end());
    } else {
      const auto& names = alternative_names<Value>;
      keys.insert(keys.end(), names.begin(), names.end());
    }
  });
  return keys;
}

}  // namespace spindrift::app
