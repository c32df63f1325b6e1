// Writes values as JSON by their type, and structs of plain data by the tables of their keys.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "app/tables/document.hpp"
#include "app/tables/table.hpp"
#include "render/frame_rate.hpp"

namespace spindrift::app {

/// The double that reads like the float: 0.1f becomes 0.1, not 0.10000000149.
Json json_of(float value);
Json json_of(const glm::vec3& value);
/// The rate as a number where it is whole, and else as a fraction in text.
Json json_of(const FrameRate& value);
inline Json json_of(double value) {
  return value;
}
inline Json json_of(int value) {
  return value;
}
inline Json json_of(bool value) {
  return value;
}
inline Json json_of(const std::string& value) {
  return value;
}

template <class E>
requires std::is_enum_v<E> Json json_of(E value) {
  return value_names<E>[static_cast<std::size_t>(value)];
}

template <class T>
Json json_of(const std::vector<T>& values);
template <Section T>
Json json_of(const T& section);
template <class T>
Json json_of(const std::optional<T>& value) {
  return value ? json_of(*value) : Json();
}

/// Puts a section's fields into `object`.
template <Section T>
void put_fields(const T& section, Json& object) {
  for_each_field<T>([&](const auto& field) {
    const auto& value = section.*field.member;
    using Value = std::remove_cvref_t<decltype(value)>;
    if (!field.key.empty()) {
      if constexpr (is_optional<Value>) {
        if (value)
          object[std::string(field.key)] = json_of(*value);
      } else if constexpr (!Alternatives<Value>) {
        object[std::string(field.key)] = json_of(value);
      }
      // Branches that are left out at compile time look alike.
    } else if constexpr (Section<Value>) {  // NOLINT(bugprone-branch-clone)
      put_fields(value, object);
    } else if constexpr (Alternatives<Value>) {
      std::visit(
          [&](const auto& chosen) {
            object[std::string(alternative_names<Value>[value.index()])] = json_of(chosen);
          },
          value);
    }
  });
}

template <Section T>
Json json_of(const T& section) {
  Json object = Json::object();
  put_fields(section, object);
  return object;
}

template <class T>
Json json_of(const std::vector<T>& values) {
  Json list = Json::array();
  for (const T& value : values)
    list.push_back(json_of(value));
  return list;
}

/// JSON laid out for people: a list or object that fits on one line stands on one line.
std::string to_text(const Json& json);

}  // namespace spindrift::app
