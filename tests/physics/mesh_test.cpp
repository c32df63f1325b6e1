// Water held by solids of triangles.
#include <catch2/catch.hpp>
#include <cmath>

#include "mesh_support.hpp"
#include "sim/run/simulation.hpp"

namespace mesh_tests {

using namespace spindrift::sim;
using namespace spindrift::test;

namespace {

constexpr float d = 0.04f, inner_radius = 0.3f, height = 0.56f;
constexpr glm::vec3 base{0.6f, 0.2f, 0.6f};

/// Water that falls a little way into a cup that stands in the air.
Settings cup(float wall) {
  Settings s;
  s.fluid.spacing = d;
  s.domain = {{0, 0, 0}, {1.2f, 1.2f, 1.2f}};
  const glm::vec3 bottom = base + glm::vec3(0, wall + 2 * d, 0);
  s.fluid.volumes = {{Cylinder{bottom, bottom + glm::vec3(0, 0.28f, 0), inner_radius - d}}};
  s.obstacles = {{solid(cup_mesh(base, inner_radius, height, wall), d)}};
  return s;
}

}  // namespace

TEST_CASE("a cup of triangles holds water, however thin its walls", "[slow]") {
  const float wall = GENERATE(0.1f, 0.4f, 0.9f, 1.5f, 3.f) * d;
  CAPTURE(wall / d);
  Simulation simulation(cup(wall));
  const FrameStatistics start = simulation.advance_to(0);
  FrameStatistics end;
  for (int k = 1; k <= 10; ++k) {
    end = simulation.advance_to(0.05 * k);
    CHECK(end.max_compression <= 0.0255);
    CHECK(end.kinetic_energy + end.potential_energy <=
          start.kinetic_energy + start.potential_energy);
    int escaped = 0;
    for (const glm::vec3 p : simulation.frame().positions) {
      const float r = std::hypot(p.x - base.x, p.z - base.z);
      escaped += p.y < base.y || (r > inner_radius + wall && p.y < base.y + height);
    }
    CHECK(escaped == 0);
  }
  // It is in the cup, not piled up: lower than it started, and over all of the bottom.
  float widest = 0;
  for (const glm::vec3 p : simulation.frame().positions)
    widest = std::max(widest, std::hypot(p.x - base.x, p.z - base.z));
  CHECK(widest > inner_radius - 1.5f * d);
  CHECK(end.potential_energy < start.potential_energy);
}

TEST_CASE("water at rest on both sides of a thin plate of triangles stays so, and off it",
          "[slow]") {
  const float wall = GENERATE(0.3f, 1.5f) * d;
  CAPTURE(wall / d);
  // The first particles are a spacing from the samples.
  const float middle = 0.6f, gap = wall < d ? 0.5f * d : 0.5f * wall;
  Settings s;
  s.fluid.spacing = d;
  s.fluid.viscosity = 1;
  s.domain = {{middle - gap - 12 * d, 0, 0}, {middle + gap + 12 * d, 0.8f, 0.4f}};
  s.fluid.volumes = {{Box{s.domain.min, {middle - gap, 0.6f, 0.4f}}},
                     {Box{{middle + gap, 0, 0}, {s.domain.max.x, 0.6f, 0.4f}}}};
  const float half = 0.5f * wall;
  s.obstacles = {{solid(box_mesh({middle - half, -0.1f, -0.1f}, {middle + half, 1, 0.5f}), d)}};
  Simulation simulation(s);
  const FrameStatistics start = simulation.advance_to(0), end = simulation.advance_to(0.5);
  CHECK(end.max_speed < 1);
  CHECK(end.kinetic_energy + end.potential_energy < 1.005 * start.potential_energy);
  CHECK(end.contacts == 0);
  int left = 0;
  for (const glm::vec3 p : simulation.frame().positions)
    left += p.x < middle;
  CHECK(left == 12 * 15 * 10);
}

TEST_CASE("water dropped on a ring and a capsule stays out of them", "[slow]") {
  Settings s;
  s.fluid.spacing = 0.05f;
  s.domain = {{-0.7f, -0.3f, -0.7f}, {0.7f, 1, 0.7f}};
  s.fluid.volumes = {{Box{{-0.5f, 0.4f, -0.5f}, {0.5f, 0.8f, 0.5f}}, {0, -2, 0}}};
  const Capsule capsule{{-0.2f, 0, 0}, {0.2f, 0.1f, 0}, 0.1f};
  s.obstacles = {{solid(torus_mesh(0.45f, 0.15f), 0.05f)}, {capsule}};
  Simulation simulation(s);
  for (int k = 1; k <= 6; ++k) {
    simulation.advance_to(0.1 * k);
    for (const glm::vec3 p : simulation.frame().positions) {
      const float in_ring = std::hypot(std::hypot(p.x, p.z) - 0.45f, p.y);
      CHECK(in_ring > 0.15f - 0.1f * 0.05f);
      const glm::vec3 axis = capsule.to - capsule.from;
      const float along = glm::dot(p - capsule.from, axis) / glm::dot(axis, axis);
      const glm::vec3 nearest = capsule.from + glm::clamp(along, 0.f, 1.f) * axis;
      CHECK(glm::distance(p, nearest) > 0.1f - 1e-5f);
    }
  }
}

}  // namespace mesh_tests
