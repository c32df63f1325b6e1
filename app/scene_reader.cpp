// Scene files into settings, by the tables of scene_fields.hpp.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <istream>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "app/frame_rate_text.hpp"
#include "app/golden_list.hpp"
#include "app/nearest_name.hpp"
#include "app/scene.hpp"
#include "app/scene_checks.hpp"
#include "app/scene_document.hpp"
#include "app/scene_fields.hpp"
#include "app/scene_meshes.hpp"
#include "app/scene_reader.hpp"
#include "app/shown_text.hpp"
#include "render/output/input_file.hpp"

namespace spindrift::app {
namespace {

std::string found_text(const Json& json) {
  const auto text = [&] {
    return shown(json.dump(-1, ' ', false, Json::error_handler_t::replace));
  };
  switch (json.type()) {
    case Json::value_t::null:
      return "null";
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "the list " + text();
    default:
      return text();
  }
}

std::string range_text(const Range& range, std::string_view unit) {
  return fmt::format("{} ... {}{}{}", range.min, range.max, unit.empty() ? "" : " ", unit);
}

/// What a value of a field must look like, for messages and bounds.
struct Bounds {
  Range range;
  std::string_view unit;
};

/// Reads a document's values into settings, and gathers all that is wrong with them.
class SceneReader {
 public:
  std::vector<Problem> problems() && { return std::move(problems_); }

  template <Section T>
  void read(const LocatedValue& value, T& into, const Bounds& = {}) {
    std::vector<std::string_view> keys;
    list_keys<T>(keys);
    std::vector<std::string_view> meant;
    if (check_keys(value, keys, meant))
      read_fields(value, into, meant);
  }

 private:
  void complain(const LocatedValue& value, std::string message) {
    problems_.push_back(value.problem(std::move(message)));
  }

  template <class T>
  static void list_keys(std::vector<std::string_view>& keys) {
    for_each_field<T>([&](const auto& field) {
      using Value = std::remove_cvref_t<decltype(std::declval<T&>().*field.member)>;
      if (!field.key.empty()) {
        keys.push_back(field.key);
      } else if constexpr (Section<Value>) {
        list_keys<Value>(keys);
      } else {
        const auto& names = alternative_names<Value>;
        keys.insert(keys.end(), names.begin(), names.end());
      }
    });
  }

  /// Whether the value is an object; its keys should be among those. @param meant the nearest
  /// names of unknown keys, which need not be found missing as well
  bool check_keys(const LocatedValue& value, const std::vector<std::string_view>& keys,
                  std::vector<std::string_view>& meant) {
    if (!value.json().is_object()) {
      complain(value, keys.empty()
                          ? fmt::format("expected an empty object {{}}, found {}",
                                        found_text(value.json()))
                          : fmt::format("expected an object {{...}} with keys out of {}, found {}",
                                        fmt::join(keys, ", "), found_text(value.json())));
      return false;
    }
    value.for_each_member([&](const std::string& key, const LocatedValue& member) {
      const bool of_editors = value.is_root() && key == "$schema";
      if (of_editors || std::find(keys.begin(), keys.end(), key) != keys.end())
        return;
      complain(member, keys.empty() ? "unknown key; none is accepted here, write {}"
                                    : fmt::format("unknown key; {}", suggestion(key, keys)));
      meant.push_back(nearest_name(key, keys));
    });
    return true;
  }

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

  /// @param is_meant one of them by an unknown key
  template <Alternatives V>
  void read_alternative(const LocatedValue& value, V& into, bool is_meant) {
    const auto& names = alternative_names<V>;
    std::vector<std::size_t> given;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (value.json().contains(names[i])) {
        given.push_back(i);
      }
    }
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

  /// A still camera is one key written straight into the section.
  void read(const LocatedValue& value, CameraSettings& into, const Bounds&) {
    std::vector<std::string_view> keys, meant;
    list_keys<CameraSettings>(keys);
    list_keys<CameraKey>(keys);
    if (!check_keys(value, keys, meant))
      return;
    const bool has_keyframes = value.json().contains("keyframes");
    const std::size_t known = value.json().size() - meant.size();
    if (has_keyframes && known > 1) {
      complain(value, "give either keyframes or a still camera, not both");
    } else if (has_keyframes) {
      read_fields(value, into, meant);
    } else if (known > 0) {
      into.keyframes.resize(1);
      read_fields(value, into.keyframes[0], meant);
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
  void read(const LocatedValue& value, std::optional<T>& into, const Bounds& bounds) {
    read(value, into.emplace(), bounds);
  }

  /// Names and files; neither goes over a line's end.
  void read(const LocatedValue& value, std::string& into, const Bounds&) {
    if (!value.json().is_string())
      return complain(value, fmt::format("expected text, found {}", found_text(value.json())));
    into = value.json().get<std::string>();
    if (holds_control_characters(into))
      complain(value, fmt::format("{} holds control characters", found_text(value.json())));
  }

  void read(const LocatedValue& value, bool& into, const Bounds&) {
    if (!value.json().is_boolean())
      return complain(value,
                      fmt::format("expected true or false, found {}", found_text(value.json())));
    into = value.json().get<bool>();
  }

  /// A number within the bounds; none, with a complaint, for anything else.
  std::optional<double> read_number(const LocatedValue& value, const Bounds& bounds) {
    const std::string accepted = range_text(bounds.range, bounds.unit);
    if (!value.json().is_number()) {
      complain(value,
               fmt::format("expected a number ({}), found {}", accepted, found_text(value.json())));
      return std::nullopt;
    }
    const double number = value.json().get<double>();
    if (!(number >= bounds.range.min && number <= bounds.range.max)) {
      complain(value,
               fmt::format("{} is out of range; accepted: {}", found_text(value.json()), accepted));
      return std::nullopt;
    }
    return number;
  }

  void read(const LocatedValue& value, double& into, const Bounds& bounds) {
    into = read_number(value, bounds).value_or(into);
  }
  void read(const LocatedValue& value, float& into, const Bounds& bounds) {
    if (const auto number = read_number(value, bounds))
      into = static_cast<float>(*number);
  }
  void read(const LocatedValue& value, int& into, const Bounds& bounds) {
    const auto number = read_number(value, bounds);
    if (!number)
      return;
    into = static_cast<int>(*number);
    if (into != *number)
      complain(value, fmt::format("{} is not a whole number; accepted: {}",
                                  found_text(value.json()), range_text(bounds.range, bounds.unit)));
  }

  void read(const LocatedValue& value, FrameRate& into, const Bounds& bounds) {
    std::optional<FrameRate> rate;
    if (value.json().is_string())
      rate = rate_of(value.json().get<std::string>());
    else if (const auto number = read_number(value, bounds))
      rate = rate_of(*number);
    else
      return;
    const std::string found = found_text(value.json()),
                      accepted = range_text(bounds.range, bounds.unit);
    if (!rate)
      complain(value,
               fmt::format("{} is no frame rate; accepted: a number with up to three decimal "
                           "places, or a fraction as text, such as \"30000/1001\" ({})",
                           found, accepted));
    else if (rate->per_second() < bounds.range.min || rate->per_second() > bounds.range.max)
      complain(value, fmt::format("{} is out of range; accepted: {}", found, accepted));
    else
      into = *rate;
  }

  void read(const LocatedValue& value, glm::vec3& into, const Bounds& bounds) {
    if (!value.json().is_array() || value.json().size() != 3)
      return complain(value,
                      fmt::format("expected three numbers [x, y, z] ({}), found {}",
                                  range_text(bounds.range, bounds.unit), found_text(value.json())));
    for (int i = 0; i < 3; ++i)
      read(value[static_cast<std::size_t>(i)], into[i], bounds);
  }

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

  // An alternative is only ever read through its owner's keys.
  template <Alternatives V>
  void read(const LocatedValue&, V&, const Bounds&) {}
  void read(const LocatedValue&, sim::Settings&, const Bounds&) {}

  std::vector<Problem> problems_;
};

template <class T>
void read_document(const SceneDocument& document, T& into) {
  SceneReader reader;
  reader.read(document.value(), into);
  throw_if_any(std::move(reader).problems());
}

}  // namespace

void read_section(const SceneDocument& document, GoldenList& into) {
  read_document(document, into);
}

namespace {

constexpr std::size_t most_scene_bytes = 32 << 20;

std::string too_long(const std::string& source) {
  return fmt::format("{}: longer than {} MB; no scene is", source, most_scene_bytes >> 20);
}

}  // namespace

Scene parse_scene(std::string_view text, const std::filesystem::path& source,
                  const Overrides& overrides) {
  SceneDocument document(text, source.string());
  const Json defaults = to_json(Scene{});
  for (const std::string& assignment : overrides) {
    document.override_value(assignment, defaults);
  }
  Scene scene;
  scene.name = source.stem().string();
  read_document(document, scene);
  auto& fluid = scene.simulation.fluid;
  if (!fluid.emitters.empty() && !document.root().at("fluid").contains("volumes")) {
    fluid.volumes.clear();  // the column that stands where nothing is said
  }
  load_meshes(scene, document, source.parent_path());
  check_scene(scene, document);
  return scene;
}

std::string scene_text(const std::filesystem::path& file) {
  try {
    std::error_code unknown;
    if (std::filesystem::file_size(file, unknown) > most_scene_bytes && !unknown)
      throw std::runtime_error(too_long(file.string()));
    return output::read_file(file);
  } catch (const std::exception& error) {
    throw SceneError(error.what());
  }
}

std::string scene_text(std::istream& stream, const std::string& source) {
  std::string text(most_scene_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > most_scene_bytes)
    throw SceneError(too_long(source));
  return text;
}

Scene read_scene(const std::filesystem::path& file, const Overrides& overrides) {
  return parse_scene(scene_text(file), file, overrides);
}

}  // namespace spindrift::app
