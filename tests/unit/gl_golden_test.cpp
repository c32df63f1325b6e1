// Pictures of small fixed scenes against those in tests/golden/renderer. Set
// SPINDRIFT_UPDATE_GOLDENS=1 to write those anew.
#include <fmt/format.h>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <memory>

#include "gl_support.hpp"

using namespace spindrift;
using namespace spindrift::gl;
using namespace spindrift::gl::test;

namespace {

constexpr int width = 320, height = 180;
constexpr int tolerance = 5;  // of 255, per channel
constexpr double share_allowed =
    0.001;  // of the pixels may be off by more: edges, on other drivers

void write_png(const std::filesystem::path& path, const Image& image) {
  std::filesystem::create_directories(path.parent_path());
  REQUIRE(stbi_write_png(path.c_str(), image.width, image.height, 3, image.pixels.data(),
                         3 * image.width));
}

Image read_png(const std::filesystem::path& path) {
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
      stbi_load(path.c_str(), &image.width, &image.height, &channels, 3), stbi_image_free);
  if (pixels) {
    image.pixels.assign(pixels.get(), pixels.get() + 3 * image.width * image.height);
  }
  return image;
}

void check_golden(const std::string& name, const Image& image) {
  const std::filesystem::path golden_path =
      std::filesystem::path(SOURCE_DIR) / "tests/golden/renderer" / (name + ".png");
  if (std::getenv("SPINDRIFT_UPDATE_GOLDENS")) {
    write_png(golden_path, image);
    return;
  }
  const Image golden = read_png(golden_path);
  bool same = golden.width == image.width && golden.height == image.height;
  int off = 0, worst = 0;
  for (int i = 0; same && i < width * height; ++i) {
    const int d =
        difference(pixel(image, i % width, i / width), pixel(golden, i % width, i / width));
    worst = std::max(worst, d);
    off += d > tolerance;
  }
  same = same && off <= share_allowed * width * height;
  if (!same) {
    const std::filesystem::path result =
        std::filesystem::path(RESULT_DIR) / "golden_results" / (name + ".png");
    write_png(result, image);
    FAIL(fmt::format(
        "{} pixels differ from {} by more than {}, the worst by {}; the picture is in {}",
        golden.pixels.empty() ? "all" : std::to_string(off), golden_path.string(), tolerance, worst,
        result.string()));
  }
}

Stage stage() {
  return {{0.f, 0.f, 0.f}, {1.6f, 1.f, 0.6f}};
}

View view() {
  View view;
  view.position = {2.3f, 1.3f, 2.4f};
  view.target = {0.75f, 0.35f, 0.25f};
  return view;
}

Mesh liquid() {
  Mesh mesh = box({0.02f, 0.01f, 0.02f}, {1.58f, 0.25f, 0.58f});
  append(mesh, ball({0.5f, 0.55f, 0.3f}, 0.16f));
  append(mesh, ball({0.85f, 0.8f, 0.35f}, 0.07f));
  return mesh;
}

}  // namespace

TEST_CASE("the liquid's surface looks as it did") {
  Renderer renderer(width, height, {}, {}, stage());
  check_golden("liquid", renderer.draw(liquid(), view()));
}

TEST_CASE("liquid around an obstacle looks as it did") {
  Renderer renderer(width, height, {}, {}, stage());
  renderer.set_obstacles(box({1.1f, 0.f, 0.2f}, {1.3f, 0.5f, 0.4f}));
  check_golden("obstacle", renderer.draw(liquid(), view()));
}

TEST_CASE("particles look as they did") {
  std::vector<glm::vec3> positions;
  std::vector<float> values;
  const float spacing = 0.05f;
  for (int i = 0; i < 32 * 12 * 6; ++i) {
    const glm::vec3 p = spacing * (glm::vec3(i % 32, i / (32 * 12), i / 32 % 12) + glm::vec3(0.5f));
    if (p.y < 0.3f - 0.15f * p.x) {
      positions.push_back(p);
      values.push_back(p.x);
    }
  }
  Renderer renderer(width, height, {}, {}, stage());
  check_golden("particles",
               renderer.draw(ParticleCloud{positions, values, 0.5f * spacing}, view()));
}
