// PNG files.
#include "render/output/output.hpp"
#include "tests/fuzz/support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spindrift;
  try {
    const Image image = output::read_png(fuzz::folder().write("a.png", fuzz::text_of(data, size)));
    fuzz::require(image.pixels.size() == std::size_t(3) * image.width * image.height);
  } catch (const std::runtime_error&) {
  }
  return 0;
}
