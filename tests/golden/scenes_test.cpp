// What the golden tests of the scenes that ship (scenes.json, one CTest test each) rest on: that
// none is left out, and that their tolerance does not let wrong shading pass.
#include <catch2/catch.hpp>
#include <filesystem>
#include <glm/gtc/matrix_transform.hpp>
#include <set>

#include "app/compare/comparison.hpp"
#include "app/golden/golden_list.hpp"
#include "gl_support.hpp"

namespace fs = std::filesystem;
namespace scenes_tests {

using namespace spindrift;

TEST_CASE("every shipped scene has a golden frame") {
  const fs::path source = SOURCE_DIR;
  std::set<fs::path> listed;
  for (const app::Golden& golden :
       app::read_golden_list(source / "tests/golden/scenes.json").goldens)
    listed.insert(fs::path(golden.scene).filename());
  for (const auto& file : fs::directory_iterator(source / "scenes")) {
    const fs::path name = file.path().filename();
    if (name.extension() == ".json" && name != "scene.schema.json")
      CHECK(listed.count(name) == 1);
  }
}

TEST_CASE("wrong normals are beyond the tolerance of golden tests") {
  Mesh mesh = gl::test::box({0.02f, 0.01f, 0.02f}, {1.58f, 0.25f, 0.58f});
  gl::test::append(mesh, gl::test::ball({0.5f, 0.55f, 0.3f}, 0.16f));
  gl::Renderer renderer(160, 90, {}, {}, {{0.f, 0.f, 0.f}, {1.6f, 1.f, 0.6f}});
  const gl::View view{.position = {2.3f, 1.3f, 2.4f}, .target = {0.75f, 0.35f, 0.25f}};
  const Image right = renderer.draw(mesh, view);
  const app::GoldenList list;
  const app::Limits limits{.max_flip = list.max_flip, .max_changed = list.max_changed};
  const auto is_seen = [&](const auto& change) {
    Mesh wrong = mesh;
    for (glm::vec3& normal : wrong.normals)
      normal = change(normal);
    const auto pair = compare::compare(right, renderer.draw(wrong, view), list.threshold);
    return !app::broken_limits(pair.tally.metrics(), limits).empty();
  };
  CHECK_FALSE(is_seen([](glm::vec3 n) { return n; }));
  CHECK(is_seen([](glm::vec3 n) { return -n; }));
  CHECK(is_seen([](glm::vec3 n) { return glm::vec3(n.x, n.z, n.y); }));
  CHECK(is_seen([](glm::vec3 n) {  // 20 degrees about z
    return glm::vec3(glm::rotate(glm::mat4(1), glm::radians(20.f), {0, 0, 1}) * glm::vec4(n, 0));
  }));
}

}  // namespace scenes_tests
