// Describes values by their type, and structs of plain data by the tables of their keys, as JSON
// schemas (draft 7) for editors.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "app/tables/table.hpp"
#include "app/tables/values.hpp"
#include "render/frame_rate.hpp"

namespace spindrift::app {

/// Whether the schema of a field that may be left out states what holds then. What is made of keys
/// of its own does not, nor what is then absent or empty.
template <class T>
inline constexpr bool states_default =
    !Section<T> && !std::is_same_v<T, Json> && !std::is_same_v<T, std::string>;
template <class T>
inline constexpr bool states_default<std::optional<T>> = false;
template <class T>
inline constexpr bool states_default<NonEmpty<T>> = false;
template <class T>
inline constexpr bool states_default<std::vector<Keyed<T>>> = false;

/// Makes the schemas of types.
class SchemaWriter {
 public:
  /// @param range of the numbers in it
  template <class T>
  static Json schema_for(const Range& range = {}) {
    return schema_of(static_cast<const T*>(nullptr), range);
  }

 private:
  // The overloads are chosen by the type of the pointer, which is always null.

  static Json schema_of(const Json*, const Range&) { return Json::object(); }
  static Json schema_of(const bool*, const Range&) { return {{"type", "boolean"}}; }
  static Json schema_of(const std::string*, const Range&) { return {{"type", "string"}}; }

  static Json schema_of(const int*, const Range& range) {
    return {{"type", "integer"},
            {"minimum", static_cast<int>(range.min)},
            {"maximum", static_cast<int>(range.max)}};
  }

  static Json schema_of(const double*, const Range& range) {
    if (std::isinf(range.max))
      return {{"type", "number"}};
    return {{"type", "number"}, {"minimum", range.min}, {"maximum", range.max}};
  }

  static Json schema_of(const float*, const Range& range) { return schema_for<double>(range); }

  static Json schema_of(const FrameRate*, const Range& range) {
    const Json fraction{{"type", "string"}, {"pattern", "^[0-9]{1,7}/[0-9]{1,7}$"}};
    return {{"anyOf", Json::array({schema_for<double>(range), fraction})}};
  }

  static Json schema_of(const glm::vec3*, const Range& range) {
    return {
        {"type", "array"}, {"items", schema_for<float>(range)}, {"minItems", 3}, {"maxItems", 3}};
  }

  template <class E>
  requires std::is_enum_v<E>
  static Json schema_of(const E*, const Range&) { return {{"enum", value_names<E>}}; }

  template <class T>
  static Json schema_of(const std::vector<T>*, const Range& of_each) {
    return {{"type", "array"}, {"items", schema_for<T>(of_each)}};
  }

  template <class T>
  static Json schema_of(const NonEmpty<T>*, const Range& of_each) {
    return {{"type", "array"}, {"minItems", 1}, {"items", schema_for<T>(of_each)}};
  }

  template <class T>
  static Json schema_of(const std::vector<Keyed<T>>*, const Range& of_each) {
    return {{"type", "object"}, {"additionalProperties", schema_for<T>(of_each)}};
  }

  template <class T>
  static Json schema_of(const Placed<T>*, const Range& range) {
    return schema_for<T>(range);
  }

  template <class T>
  static Json schema_of(const std::optional<T>*, const Range& range) {
    return schema_for<T>(range);
  }

  template <Section T>
  static Json schema_of(const T*, const Range&) {
    Json schema{{"type", "object"}, {"properties", Json::object()}};
    put_properties<T>(schema);
    schema["additionalProperties"] = false;
    if constexpr (lone_entry_name<T>.empty())
      return schema;
    else
      return {{"anyOf", Json::array({schema, schema_for<LoneEntry<T>>()})}};
  }

  template <Section T>
  static void put_properties(Json& schema) {
    for_each_field<T>([&](const auto& field) {
      using Value = std::remove_cvref_t<decltype(std::declval<T&>().*field.member)>;
      if constexpr (Alternatives<Value>) {
        put_alternatives<Value>(schema, std::make_index_sequence<std::variant_size_v<Value>>());
      } else {
        if constexpr (Section<Value>) {
          if (field.key.empty())
            return put_properties<Value>(schema);
        }
        schema["properties"][std::string(field.key)] = field_schema<T, Value>(field);
        if (field.presence == Presence::required)
          schema["required"].push_back(field.key);
      }
    });
  }

  /// The schema of a field's value, with the field's description, unit and default.
  template <class T, class Value>
  static Json field_schema(const Field<T, Value>& field) {
    Json schema;
    schema["description"] = field.unit.empty() ? std::string(field.about)
                                               : fmt::format("{} ({})", field.about, field.unit);
    schema.update(schema_for<Value>(field.range));
    if constexpr (states_default<Value>)
      if (field.presence == Presence::optional)
        schema["default"] = json_of(T{}.*field.member);
    return schema;
  }

  template <Alternatives V, std::size_t... I>
  static void put_alternatives(Json& schema, std::index_sequence<I...>) {
    Json alternatives = Json::array();
    const auto put = [&]<class T>(std::string_view name, const T*) {
      schema["properties"][std::string(name)] = schema_for<T>();
      alternatives.push_back({{"required", Json::array({name})}});
    };
    (put(alternative_names<V>[I], static_cast<const std::variant_alternative_t<I, V>*>(nullptr)),
     ...);
    schema["oneOf"] = alternatives;
  }
};

/// The schema of whole files.
template <Section T>
Json document_schema(std::string_view title, std::string_view about) {
  Json schema{{"$schema", "http://json-schema.org/draft-07/schema#"},
              {"title", title},
              {"description", about}};
  schema.update(SchemaWriter::schema_for<T>());
  schema["properties"]["$schema"] = {{"type", "string"}};
  return schema;
}

}  // namespace spindrift::app
