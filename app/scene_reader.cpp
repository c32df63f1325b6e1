// Scene files into settings, by the tables of scene_fields.hpp.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <fstream>
#include <iterator>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "app/golden_list.hpp"
#include "app/nearest_name.hpp"
#include "app/scene.hpp"
#include "app/scene_checks.hpp"
#include "app/scene_document.hpp"
#include "app/scene_fields.hpp"
#include "app/scene_meshes.hpp"
#include "app/scene_reader.hpp"

namespace spindrift::app {
namespace {

std::string found_text(const Json& json) {
  const auto shorten = [](std::string text) {
    return text.size() > 40 ? text.substr(0, 37) + "..." : text;
  };
  switch (json.type()) {
    case Json::value_t::null:
      return "null";
    case Json::value_t::object:
      return "an object";
    case Json::value_t::array:
      return "the list " + shorten(json.dump(-1, ' ', false, Json::error_handler_t::replace));
    default:
      return shorten(json.dump(-1, ' ', false, Json::error_handler_t::replace));
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

template <class T>
inline constexpr bool is_vector = false;
template <class T>
inline constexpr bool is_vector<std::vector<T>> = true;

class SceneReader {
 public:
  explicit SceneReader(const SceneDocument& document) : document_(document) {}

  template <Section T>
  void read(const Json& json, const std::string& path, T& into, const Bounds& = {}) {
    std::vector<std::string_view> keys;
    list_keys<T>(keys);
    check_keys(json, path, keys);
    read_fields(json, path, into);
  }

 private:
  [[noreturn]] void fail(const std::string& path, const std::string& message) const {
    throw SceneError(fmt::format("{}: {}{}{}", document_.place_of(path), path,
                                 path.empty() ? "" : ": ", message));
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

  void check_keys(const Json& json, const std::string& path,
                  const std::vector<std::string_view>& keys) const {
    if (!json.is_object() && keys.empty()) {
      fail(path, fmt::format("expected an empty object {{}}, found {}", found_text(json)));
    }
    if (!json.is_object()) {
      fail(path, fmt::format("expected an object {{...}} with keys out of {}, found {}",
                             fmt::join(keys, ", "), found_text(json)));
    }
    for (const auto& [key, value] : json.items()) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) {
        fail(child_path(path, key), keys.empty()
                                        ? "unknown key; none is accepted here, write {}"
                                        : fmt::format("unknown key; {}", suggestion(key, keys)));
      }
    }
  }

  template <Section T>
  void read_fields(const Json& json, const std::string& path, T& into) {
    for_each_field<T>([&](const auto& field) {
      auto& value = into.*field.member;
      using Value = std::remove_reference_t<decltype(value)>;
      if (field.key.empty()) {
        if constexpr (Section<Value>) {
          read_fields(json, path, value);
        } else if constexpr (Alternatives<Value>) {
          read_alternative(json, path, value);
        }
        return;
      }
      const auto found = json.find(field.key);
      if (found != json.end()) {
        read(*found, child_path(path, field.key), value, Bounds{field.range, field.unit});
      } else if (field.presence == Presence::required) {
        fail(path, fmt::format("\"{}\" is missing ({})", field.key, field.about));
      }
    });
  }

  template <Alternatives V>
  void read_alternative(const Json& json, const std::string& path, V& into) {
    const auto& names = alternative_names<V>;
    std::vector<std::size_t> given;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (json.contains(names[i])) {
        given.push_back(i);
      }
    }
    if (given.size() != 1) {
      fail(path, fmt::format("expected one {} out of {}, found {}", variant_name<V>,
                             fmt::join(names, ", "), given.size()));
    }
    into = all_alternatives<V>(std::make_index_sequence<std::variant_size_v<V>>())[given[0]];
    const std::string_view name = names[given[0]];
    std::visit(
        [&](auto& chosen) { read(json.at(std::string(name)), child_path(path, name), chosen); },
        into);
  }

  template <class V, std::size_t... I>
  static std::array<V, sizeof...(I)> all_alternatives(std::index_sequence<I...>) {
    return {V(std::in_place_index<I>)...};
  }

  /// A still camera is one key written straight into the section.
  void read(const Json& json, const std::string& path, CameraSettings& into, const Bounds&) {
    std::vector<std::string_view> keys;
    list_keys<CameraSettings>(keys);
    list_keys<CameraKey>(keys);
    check_keys(json, path, keys);
    const bool has_keyframes = json.contains("keyframes");
    if (has_keyframes && json.size() > 1) {
      fail(path, "give either keyframes or a still camera, not both");
    }
    if (has_keyframes) {
      read_fields(json, path, into);
    } else if (!json.empty()) {
      into.keyframes.resize(1);
      read_fields(json, path, into.keyframes[0]);
    }
  }

  template <class T>
  void read(const Json& json, const std::string& path, std::vector<T>& into,
            const Bounds& of_each) {
    if (!json.is_array()) {
      fail(path, fmt::format("expected a list [...], found {}", found_text(json)));
    }
    into.clear();
    for (std::size_t i = 0; i < json.size(); ++i) {
      into.emplace_back();
      read(json[i], child_path(path, i), into.back(), of_each);
    }
  }

  template <class T>
  void read(const Json& json, const std::string& path, std::optional<T>& into,
            const Bounds& bounds) {
    read(json, path, into.emplace(), bounds);
  }

  void read(const Json& json, const std::string& path, std::string& into, const Bounds&) {
    if (!json.is_string()) {
      fail(path, fmt::format("expected text, found {}", found_text(json)));
    }
    into = json.get<std::string>();
  }

  void read(const Json& json, const std::string& path, bool& into, const Bounds&) {
    if (!json.is_boolean()) {
      fail(path, fmt::format("expected true or false, found {}", found_text(json)));
    }
    into = json.get<bool>();
  }

  double read_number(const Json& json, const std::string& path, const Bounds& bounds) const {
    const std::string accepted = range_text(bounds.range, bounds.unit);
    if (!json.is_number()) {
      fail(path, fmt::format("expected a number ({}), found {}", accepted, found_text(json)));
    }
    const double number = json.get<double>();
    if (!(number >= bounds.range.min && number <= bounds.range.max)) {
      fail(path, fmt::format("{} is out of range; accepted: {}", found_text(json), accepted));
    }
    return number;
  }

  void read(const Json& json, const std::string& path, double& into, const Bounds& bounds) {
    into = read_number(json, path, bounds);
  }
  void read(const Json& json, const std::string& path, float& into, const Bounds& bounds) {
    into = static_cast<float>(read_number(json, path, bounds));
  }
  void read(const Json& json, const std::string& path, int& into, const Bounds& bounds) {
    const double number = read_number(json, path, bounds);
    into = static_cast<int>(number);
    if (into != number) {
      fail(path, fmt::format("{} is not a whole number; accepted: {}", found_text(json),
                             range_text(bounds.range, bounds.unit)));
    }
  }

  void read(const Json& json, const std::string& path, glm::vec3& into, const Bounds& bounds) {
    if (!json.is_array() || json.size() != 3) {
      fail(path, fmt::format("expected three numbers [x, y, z] ({}), found {}",
                             range_text(bounds.range, bounds.unit), found_text(json)));
    }
    for (int i = 0; i < 3; ++i) {
      read(json[static_cast<std::size_t>(i)], child_path(path, static_cast<std::size_t>(i)),
           into[i], bounds);
    }
  }

  template <class E>
  requires std::is_enum_v<E>
  void read(const Json& json, const std::string& path, E& into, const Bounds&) {
    const auto& names = value_names<E>;
    if (!json.is_string()) {
      fail(path,
           fmt::format("expected one of {}, found {}", fmt::join(names, ", "), found_text(json)));
    }
    const auto typed = json.get<std::string>();
    const auto found = std::find(names.begin(), names.end(), typed);
    if (found == names.end()) {
      fail(path, fmt::format("unknown value {}; {}", found_text(json), suggestion(typed, names)));
    }
    into = static_cast<E>(found - names.begin());
  }

  // An alternative is only ever read through its owner's keys.
  template <Alternatives V>
  void read(const Json&, const std::string&, V&, const Bounds&) {}
  void read(const Json&, const std::string&, sim::Settings&, const Bounds&) {}

  const SceneDocument& document_;
};

/// What a document holds, but for the name of its schema, which is for editors.
Json content_of(const SceneDocument& document) {
  Json root = document.root();
  if (root.is_object()) {
    root.erase("$schema");
  }
  return root;
}

}  // namespace

void read_section(const SceneDocument& document, GoldenList& into) {
  SceneReader(document).read(content_of(document), "", into);
}

Scene parse_scene(std::string_view text, const std::filesystem::path& source,
                  const Overrides& overrides) {
  SceneDocument document(text, source.string());
  const Json defaults = to_json(Scene{});
  for (const std::string& assignment : overrides) {
    document.override_value(assignment, defaults);
  }
  const Json root = content_of(document);
  Scene scene;
  scene.name = source.stem().string();
  SceneReader(document).read(root, "", scene);
  auto& fluid = scene.simulation.fluid;
  if (!fluid.emitters.empty() && !root.at("fluid").contains("volumes")) {
    fluid.volumes.clear();  // the column that stands where nothing is said
  }
  load_meshes(scene, document, source.parent_path());
  check_scene(scene, document);
  return scene;
}

std::string scene_text(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file)) {
    throw SceneError(fmt::format("{}: there is no such file", file.string()));
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file)) {
    throw SceneError(fmt::format("{}: this file can't be read", file.string()));
  }
  return {std::istreambuf_iterator<char>(stream), {}};
}

Scene read_scene(const std::filesystem::path& file, const Overrides& overrides) {
  return parse_scene(scene_text(file), file, overrides);
}

}  // namespace spindrift::app
