// Walls that nothing passes, however thin they are and whichever way they move.
#include <catch2/catch.hpp>
#include <cmath>
#include <functional>
#include <map>

#include "mesh_support.hpp"
#include "sim/boundary/obstacle_motion.hpp"
#include "sim/run/simulation.hpp"
#include "sim/start/initial.hpp"

namespace walls_tests {

using namespace spindrift::sim;
using namespace spindrift::test;

namespace {

constexpr float d = 0.04f;  // spacing, m

enum class Kind { box, disc, mesh };

/// A plate across y around a height, wider than the domain; m.
Shape plate(Kind kind, float height, float thickness) {
  const float half = 0.5f * thickness;
  if (kind == Kind::disc)
    return Cylinder{{0.5f, height - half, 0.25f}, {0.5f, height + half, 0.25f}, 1};
  if (kind == Kind::box)
    return Box{{-0.1f, height - half, -0.1f}, {1.1f, height + half, 0.6f}};
  return solid(box_mesh({-0.1f, height - half, -0.1f}, {1.1f, height + half, 0.6f}), d);
}

/// Water over a place, in a tank.
Settings tank(const Box& water) {
  Settings s;
  s.fluid.spacing = d;
  s.domain = {{0, 0, 0}, {1, 1, 0.5f}};
  s.fluid.volumes = {{water}};
  return s;
}

Settings drop_on_plate(Kind kind, float thickness) {
  Settings s = tank({{0.36f, 0.72f, 0.09f}, {0.64f, 0.96f, 0.41f}});
  s.obstacles = {{plate(kind, 0.35f, thickness)}};
  return s;
}

/// Calls look(frame) twenty times a second; returns the worst compression of any frame.
double run(Simulation& simulation, double end, const std::function<void(const Frame&)>& look) {
  double worst = 0;
  for (double time = 0; time <= end; time += 0.05) {
    worst = std::max(worst, simulation.advance_to(time).max_compression);
    look(simulation.frame());
  }
  return worst;
}

/// How far a particle is above a plane with the given normal, m.
float above(const glm::vec3& p, const glm::vec3& point, const glm::vec3& normal) {
  return glm::dot(p - point, normal);
}

}  // namespace

TEST_CASE("nothing comes through a plate, however thin, of any kind", "[slow]") {
  const Kind kind = GENERATE(Kind::box, Kind::disc, Kind::mesh);
  const float thickness = GENERATE(0.005f, 0.05f, 0.3f) * d;
  CAPTURE(static_cast<int>(kind), thickness / d);
  Simulation simulation(drop_on_plate(kind, thickness));
  const double compression = run(simulation, 1, [](const Frame& frame) {
    REQUIRE(frame.positions.size() == 336);
    for (const glm::vec3& p : frame.positions)
      REQUIRE(p.y > 0.35f);
  });
  CHECK(compression <= 0.0255);
}

TEST_CASE("nothing comes through a plate of triangles that stands askew", "[slow]") {
  const float thickness = GENERATE(0.005f, 0.05f) * d;
  CAPTURE(thickness / d);
  TriangleSurface mesh = box_mesh({-1, -0.5f * thickness, -1}, {1, 0.5f * thickness, 1});
  const glm::vec3 normal = glm::normalize(glm::vec3(0.4f, 1, 0.2f));
  const glm::vec3 across = glm::normalize(glm::cross(normal, glm::vec3(0, 0, 1)));
  const glm::mat3 turn(across, normal, glm::cross(across, normal));
  const glm::vec3 middle(0.5f, 0.4f, 0.25f);
  for (glm::vec3& v : mesh.vertices)
    v = middle + turn * v;
  Settings s = tank({{0.36f, 0.72f, 0.09f}, {0.64f, 0.96f, 0.41f}});
  s.obstacles = {{solid(mesh, d)}};
  Simulation simulation(s);
  run(simulation, 1, [&](const Frame& frame) {
    for (const glm::vec3& p : frame.positions)
      REQUIRE(above(p, middle, normal) > 0);
  });
}

TEST_CASE("nothing comes through a thin plate that is thrust through water, or turned in it",
          "[slow]") {
  const Kind kind = GENERATE(Kind::box, Kind::mesh);
  const float thickness = GENERATE(0.005f, 0.3f) * d;
  CAPTURE(static_cast<int>(kind), thickness / d);
  Settings s = tank({{0.2f, 0.36f, 0.1f}, {0.8f, 0.6f, 0.4f}});
  s.obstacles = {{.shape = plate(kind, 0.2f, thickness), .motion = Motion{}}};
  Motion& motion = *s.obstacles[0].motion;
  motion.pivot = {0.5f, 0.2f, 0.25f};
  motion.keyframes = {{.time = 0.1f, .translate = {0, 0, 0}, .rotate = {0, 0, 0}},
                      {.time = 0.2f, .translate = {0, 0.2f, 0}, .rotate = {0, 0, 15}},
                      {.time = 0.4f, .translate = {0, 0.1f, 0}, .rotate = {0, 0, -10}}};
  Simulation simulation(s);
  run(simulation, 0.6, [&](const Frame& frame) {
    const Pose pose = pose_at(s.obstacles[0], frame.time);
    const glm::dvec3 point = pose(glm::dvec3(0.5, 0.2, 0.25));
    const glm::dvec3 normal = pose(glm::dvec3(0.5, 1.2, 0.25)) - point;
    for (const glm::vec3& p : frame.positions)
      REQUIRE(above(p, glm::vec3(point), glm::vec3(normal)) > 0);
  });
}

TEST_CASE("water that starts on both sides of a thin plate stays on both", "[slow]") {
  const bool is_mesh = GENERATE(false, true);
  const float thickness = GENERATE(0.005f, 0.1f) * d;
  CAPTURE(is_mesh, thickness / d);
  // Of the lattice's layers one is a quarter of a spacing off the plate: the start is let apart.
  const float at = 0.49f;
  Settings s = tank({{0, 0, 0}, {1, 0.4f, 0.48f}});
  s.domain.max.z = 0.48f;
  const glm::vec3 low(at - 0.5f * thickness, -0.1f, -0.1f), high(at + 0.5f * thickness, 1.1f, 0.6f);
  s.obstacles = {{is_mesh ? Shape(solid(box_mesh(low, high), d)) : Shape(Box{low, high})}};
  Simulation simulation(s);
  std::map<std::uint32_t, bool> is_left;
  for (const glm::vec3& p : fill_volumes(s).positions)
    is_left.emplace(static_cast<std::uint32_t>(is_left.size()), p.x < at);
  run(simulation, 0.3, [&](const Frame& frame) {
    for (std::size_t i = 0; i < frame.ids.size(); ++i)
      REQUIRE(is_left.at(frame.ids[i]) == (frame.positions[i].x < at));
  });
}

TEST_CASE("nothing creeps out where the plates of a thin box meet") {
  // Four plates that stand on a fifth: their faces touch, and none of them has a bottom of its own.
  const float t = 0.02f * d, low = 0.3f, high = 0.7f;
  Settings s = tank({{0.36f, 0.2f, 0.16f}, {0.64f, 0.56f, 0.4f}});
  s.domain.max.z = 0.56f;
  const float near = 0.08f, far = 0.48f, bottom = 0.1f, top = 0.9f;
  s.obstacles = {{Box{{low, bottom - t, near}, {high, bottom, far}}},
                 {Box{{low - t, bottom, near}, {low, top, far}}},
                 {Box{{high, bottom, near}, {high + t, top, far}}},
                 {Box{{low, bottom, near - t}, {high, top, near}}},
                 {Box{{low, bottom, far}, {high, top, far + t}}}};
  Simulation simulation(s);
  run(simulation, 1, [&](const Frame& frame) {
    for (const glm::vec3& p : frame.positions) {
      CAPTURE(p.x, p.y, p.z);
      REQUIRE((p.x > low && p.x < high && p.y > bottom && p.z > near && p.z < far));
    }
  });
}

}  // namespace walls_tests
