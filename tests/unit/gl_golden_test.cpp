// Pictures of small fixed scenes against those in tests/golden/renderer. Set
// SPINDRIFT_UPDATE_GOLDENS=1 to write those anew.
#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>

#include "gl_support.hpp"
#include "render/compare/metrics.hpp"
#include "render/output/output.hpp"

namespace gl_golden_tests {

using namespace spindrift;
using namespace spindrift::gl;
using namespace spindrift::gl::test;

namespace {

constexpr int width = 320, height = 180;
constexpr int tolerance = 5;  // of 255, per channel
constexpr double share_allowed =
    0.001;  // of the pixels may be off by more: edges, on other drivers

void check_golden(const std::string& name, const Image& image) {
  namespace fs = std::filesystem;
  const fs::path golden = fs::path(SOURCE_DIR) / "tests/golden/renderer" / (name + ".png");
  if (std::getenv("SPINDRIFT_UPDATE_GOLDENS")) {
    output::write_png(golden, image);
    return;
  }
  const auto pair = compare::compare(output::read_png(golden), image, tolerance);
  const double changed = pair.tally.metrics().changed;
  const fs::path result = fs::path(RESULT_DIR) / "golden_results" / (name + ".png");
  if (changed > share_allowed) {
    fs::create_directories(result.parent_path());
    output::write_png(result, image);
  }
  INFO(golden << " differs; the picture is in " << result);
  CHECK(changed <= share_allowed);
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

}  // namespace gl_golden_tests
