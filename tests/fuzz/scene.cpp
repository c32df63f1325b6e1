// Scene files: what is accepted is written, and read again as the same scene.
#include "app/scene/scene.hpp"
#include "tests/fuzz/support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spindrift;
  try {
    const auto json = app::to_json(app::parse_scene(fuzz::text_of(data, size), "scene.json"));
    fuzz::require(app::to_json(app::parse_scene(json.dump(), "scene.json")) == json);
  } catch (const app::SceneError&) {
  }
  return 0;
}
