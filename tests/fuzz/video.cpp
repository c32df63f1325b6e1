// Videos, in the containers that are read. libav is not instrumented: what is found here is mostly
// found by chance.
#include "render/output/output.hpp"
#include "tests/fuzz/support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spindrift;
  try {
    output::VideoReader reader(fuzz::folder().write("a.mp4", fuzz::text_of(data, size)));
    for (int k = 0; k < 20; ++k) {
      const auto image = reader.next();
      if (!image)
        break;
      fuzz::require(image->pixels.size() == std::size_t(3) * image->width * image->height);
    }
  } catch (const std::runtime_error&) {
  }
  return 0;
}
