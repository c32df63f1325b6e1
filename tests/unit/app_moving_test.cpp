// Moving obstacles in scene files and in pictures.
#include <array>
#include <catch2/catch.hpp>

#include "app/draw/obstacle_mesh.hpp"
#include "app/scene/scene.hpp"

namespace app_moving_tests {

using namespace spindrift;
using namespace spindrift::app;

namespace {

const std::string scene_text = R"({"obstacles": [
  {"sphere": {"center": [2, 1, 0.4], "radius": 0.1}},
  {"box": {"min": [1, 0, 0.3], "max": [1.2, 0.5, 0.5]}, "wall_viscosity": 0.5,
   "motion": {"pivot": [1, 0, 0.4], "interpolation": "linear",
              "keyframes": [{"time": 1}, {"time": 2, "translate": [0, 1, 0], "rotate": [0, 0, 90]}],
              "oscillations": [{"translate": [0, 0, 0.1], "frequency": 0.5, "phase": 90}],
              "spin": {"axis": [0, 1, 0], "frequency": 0}}}]})";

/// The box around the vertices of which `wanted` holds.
sim::Box bounds(const Mesh& mesh, bool (*wanted)(const glm::vec3&)) {
  sim::Box box{glm::vec3(1e9f), glm::vec3(-1e9f)};
  for (const glm::vec3& v : mesh.vertices)
    if (wanted(v)) {
      box.min = glm::min(box.min, v);
      box.max = glm::max(box.max, v);
    }
  return box;
}

}  // namespace

TEST_CASE("a motion and a friction of its own are read, dumped and hashed") {
  const Scene scene = parse_scene(scene_text, "s.json");
  const sim::Obstacle &fixed = scene.simulation.obstacles[0],
                      &moving = scene.simulation.obstacles[1];
  CHECK_FALSE(fixed.motion.has_value());
  CHECK_FALSE(fixed.wall_viscosity.has_value());
  REQUIRE(moving.motion.has_value());
  CHECK(moving.wall_viscosity == 0.5f);
  CHECK(moving.motion->keyframes[1].rotate == glm::vec3(0, 0, 90));
  const auto json = to_json(scene);
  CHECK(json["obstacles"][0].size() == 1);  // what is left out stays out
  CHECK(json["obstacles"][1]["motion"]["oscillations"][0]["phase"] == 90.);
  CHECK(to_json(parse_scene(json.dump(), "s.json")) == json);
  const std::string hash = simulation_hash(scene);
  for (const char* change :
       {"obstacles[1].wall_viscosity=0.4", "obstacles[1].motion.spin.frequency=1",
        "obstacles[1].motion.keyframes[1].time=3"})
    CHECK(simulation_hash(parse_scene(scene_text, "s.json", {change})) != hash);
}

TEST_CASE("obstacles are drawn where they are at the picture's time") {
  const Scene scene = parse_scene(scene_text, "s.json");
  const ObstacleMeshes meshes(scene.simulation.obstacles);
  REQUIRE(meshes.move());
  const auto is_box = [](const glm::vec3& v) { return v.x < 1.5f; };
  const auto is_ball = [](const glm::vec3& v) { return v.x > 1.5f; };
  const Mesh start = meshes.at(0), end = meshes.at(2);
  CHECK(bounds(start, is_ball).max == bounds(end, is_ball).max);
  const sim::Box at_start = bounds(start, is_box), at_end = bounds(end, is_box);
  CHECK(glm::distance(at_start.min, glm::vec3(1, 0, 0.4f)) < 1e-5f);
  CHECK(glm::distance(at_start.max, glm::vec3(1.2f, 0.5f, 0.6f)) < 1e-5f);
  CHECK(glm::distance(at_end.min, glm::vec3(0.5f, 1, 0.4f)) < 1e-5f);
  CHECK(glm::distance(at_end.max, glm::vec3(1, 1.2f, 0.6f)) < 1e-5f);
  for (std::size_t i = 0; i < end.triangles.size(); ++i) {
    const glm::uvec3& t = end.triangles[i];
    const glm::vec3 face =
        glm::cross(end.vertices[t.y] - end.vertices[t.x], end.vertices[t.z] - end.vertices[t.x]);
    if (glm::length(face) > 0)
      CHECK(glm::dot(face, end.normals[t.x]) > 0);
  }
  const std::array times{0., 2.};
  const auto reach = meshes.reach(times);
  REQUIRE(reach.size() == 2);
  CHECK(glm::all(glm::lessThan(reach[0], glm::min(at_start.min, at_end.min))));
  CHECK(glm::all(glm::greaterThan(reach[1], glm::max(at_start.max, at_end.max))));
}

}  // namespace app_moving_tests
