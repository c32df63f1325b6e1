// Writes scenes as JSON, and their JSON schema, by the tables of scene_fields.hpp.
#include "app/scene/scene.hpp"
#include "app/scene/scene_fields.hpp"
#include "app/tables/schema.hpp"
#include "app/tables/values.hpp"

namespace spindrift::app {

Json to_json(const Scene& scene) {
  return json_of(scene);
}

Json scene_schema() {
  return document_schema<Scene>(
      "Spindrift scene", "A liquid scene: SI units, y up, right-handed. Every key has a default.");
}

}  // namespace spindrift::app
