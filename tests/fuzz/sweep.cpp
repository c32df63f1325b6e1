// Sweep files, whose scene is a small one.
#include "app/scene/scene.hpp"
#include "app/sweep/sweep_file.hpp"
#include "tests/fuzz/support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spindrift;
  try {
    app::read_sweep_file(fuzz::folder().write("sweep.json", fuzz::text_of(data, size)));
  } catch (const app::SceneError&) {
  }
  return 0;
}
