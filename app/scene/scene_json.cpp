// Writes scenes as JSON, and their JSON schema, by the tables of scene_fields.hpp.
#include <fmt/format.h>

#include <type_traits>
#include <vector>

#include "app/scene/scene.hpp"
#include "app/scene/scene_fields.hpp"
#include "app/tables/values.hpp"

namespace spindrift::app {
namespace {

// The overloads are chosen by the type of the pointer, which is always null.
Json schema_of(const bool*, const Range&) {
  return {{"type", "boolean"}};
}
Json schema_of(const std::string*, const Range&) {
  return {{"type", "string"}};
}
Json schema_of(const int*, const Range& range) {
  return {{"type", "integer"},
          {"minimum", static_cast<int>(range.min)},
          {"maximum", static_cast<int>(range.max)}};
}
Json schema_of(const double*, const Range& range) {
  return {{"type", "number"}, {"minimum", range.min}, {"maximum", range.max}};
}
Json schema_of(const float*, const Range& range) {
  return schema_of(static_cast<const double*>(nullptr), range);
}
Json schema_of(const FrameRate*, const Range& range) {
  return {{"anyOf", Json::array({schema_of(static_cast<const double*>(nullptr), range),
                                 {{"type", "string"}, {"pattern", "^[0-9]{1,7}/[0-9]{1,7}$"}}})}};
}
Json schema_of(const glm::vec3*, const Range& range) {
  return {{"type", "array"},
          {"items", schema_of(static_cast<const float*>(nullptr), range)},
          {"minItems", 3},
          {"maxItems", 3}};
}

template <class E>
requires std::is_enum_v<E> Json schema_of(const E*, const Range&) {
  Json names = Json::array();
  for (const std::string_view name : value_names<E>)
    names.push_back(name);
  return {{"enum", names}};
}

template <class T>
Json schema_of(const std::vector<T>*, const Range&);
template <Section T>
Json schema_of(const T*, const Range&);
Json schema_of(const CameraSettings*, const Range&);

template <class T>
Json schema_of(const std::optional<T>*, const Range&);

template <class T>
Json schema_for(const Range& range = {}) {
  return schema_of(static_cast<const T*>(nullptr), range);
}

template <Alternatives V, std::size_t... I>
void put_alternatives(Json& schema, std::index_sequence<I...>) {
  Json alternatives = Json::array();
  const auto put = [&]<class T>(std::string_view name, const T*) {
    schema["properties"][std::string(name)] = schema_for<T>();
    alternatives.push_back({{"required", Json::array({name})}});
  };
  (put(alternative_names<V>[I], static_cast<const std::variant_alternative_t<I, V>*>(nullptr)),
   ...);
  schema["oneOf"] = alternatives;
}

/// The schema of a field's value, with the field's description, unit and default.
template <class T, class FieldType>
Json field_schema(const FieldType& field) {
  using Value = std::remove_cvref_t<decltype(std::declval<T&>().*field.member)>;
  Json schema;
  schema["description"] = field.unit.empty() ? std::string(field.about)
                                             : fmt::format("{} ({})", field.about, field.unit);
  schema.update(schema_for<Value>(field.range));
  if constexpr (!Section<Value> && !is_optional<Value>) {
    if (field.presence == Presence::optional && !std::is_same_v<Value, std::string>)
      schema["default"] = json_of(T{}.*field.member);
  }
  return schema;
}

template <Section T>
void put_properties(Json& schema) {
  for_each_field<T>([&](const auto& field) {
    using Value = std::remove_cvref_t<decltype(std::declval<T&>().*field.member)>;
    if constexpr (Alternatives<Value>) {
      put_alternatives<Value>(schema, std::make_index_sequence<std::variant_size_v<Value>>());
    } else if constexpr (std::is_same_v<Value, sim::Settings>) {
      put_properties<Value>(schema);
    } else {
      schema["properties"][std::string(field.key)] = field_schema<T>(field);
      if (field.presence == Presence::required)
        schema["required"].push_back(field.key);
    }
  });
}

template <Section T>
Json schema_of(const T*, const Range&) {
  Json schema{{"type", "object"}, {"properties", Json::object()}};
  put_properties<T>(schema);
  schema["additionalProperties"] = false;
  return schema;
}

template <class T>
Json schema_of(const std::vector<T>*, const Range&) {
  return {{"type", "array"}, {"items", schema_for<T>()}};
}

template <class T>
Json schema_of(const std::optional<T>*, const Range& range) {
  return schema_for<T>(range);
}

/// The camera is an object with keyframes, or the keys of a single keyframe.
Json schema_of(const CameraSettings*, const Range&) {
  Json keyframes{{"type", "object"}, {"properties", Json::object()}};
  put_properties<CameraSettings>(keyframes);
  keyframes["additionalProperties"] = false;
  return {{"anyOf", Json::array({keyframes, schema_for<CameraKey>()})}};
}

}  // namespace

Json to_json(const Scene& scene) {
  return json_of(scene);
}

Json scene_schema() {
  Json schema{
      {"$schema", "http://json-schema.org/draft-07/schema#"},
      {"title", "Spindrift scene"},
      {"description", "A liquid scene: SI units, y up, right-handed. Every key has a default."}};
  schema.update(schema_for<Scene>());
  schema["properties"]["$schema"] = {{"type", "string"}};
  return schema;
}

}  // namespace spindrift::app
