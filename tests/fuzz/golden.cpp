// Lists of golden tests, whose scene "s.json" is a small one.
#include "app/golden/golden_list.hpp"
#include "tests/fuzz/support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spindrift;
  static const auto scene = fuzz::folder().write(
      "s.json", R"({"fluid": {"spacing": 0.1}, "video": {"width": 64, "height": 64}})");
  try {
    app::read_golden_list(fuzz::folder().write("golden.json", fuzz::text_of(data, size)));
  } catch (const app::SceneError&) {
  }
  return 0;
}
