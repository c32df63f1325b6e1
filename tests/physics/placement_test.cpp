// Liquid begins at rest where its lattice does not fit its walls by itself.
#include <algorithm>
#include <catch2/catch.hpp>
#include <vector>

#include "sim/geometry/solid.hpp"
#include "sim/run/simulation.hpp"
#include "sim/start/initial.hpp"

namespace placement_tests {

using namespace spindrift::sim;

namespace {

Settings pool(float spacing, float depth) {
  Settings s;
  s.fluid.spacing = spacing;
  s.domain = {{0, 0, 0}, {1, 0.8f, 0.5f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {1, depth, 0.5f}}}};
  return s;
}

/// m/s, of all particles, looked at every hundredth of a second.
double fastest_until(const Settings& settings, double end) {
  Simulation simulation(settings);
  double fastest = 0;
  for (int k = 0; k * 0.01 <= end; ++k)
    fastest = std::max(fastest, simulation.advance_to(k * 0.01).max_speed);
  return fastest;
}

}  // namespace

TEST_CASE("a pool at a spacing that does not divide it starts at rest") {
  const float d = GENERATE(0.05f, 0.06f, 0.07f);
  CHECK(fastest_until(pool(d, 0.4f), 1) < 0.3);
}

TEST_CASE("a pool at a finer spacing that does not divide it starts at rest", "[slow]") {
  CHECK(fastest_until(pool(0.03f, 0.4f), 1) < 0.3);
}

TEST_CASE("a pool with a pier in it starts at rest") {
  Settings s = pool(0.05f, 0.4f);
  s.obstacles = {{Box{{0.4f, 0, 0.15f}, {0.6f, 0.6f, 0.35f}}}};
  CHECK(fastest_until(s, 1) < 0.3);
}

TEST_CASE("a pool with a ball in it starts at rest", "[slow]") {
  Settings s = pool(0.025f, 0.5f);
  s.obstacles = {{Sphere{{0.5f, 0.25f, 0.25f}, 0.12f}}};
  CHECK(fastest_until(s, 1) < 0.3);
}

TEST_CASE("a pool starts nearly at rest around bodies anywhere between its layers") {
  Settings s = pool(0.05f, 0.4f);
  s.obstacles = {GENERATE(Obstacle{Box{{0.41f, 0, 0.163f}, {0.613f, 0.6f, 0.366f}}},
                          Obstacle{Cylinder{{0.5f, 0, 0.25f}, {0.5f, 0.7f, 0.25f}, 0.1f}})};
  CHECK(fastest_until(s, 0.5) < 0.4);
}

TEST_CASE("liquid that is brought to rest beside a body keeps its speed, as all other does") {
  Settings s = pool(0.05f, 0.4f);
  s.obstacles = {{Sphere{{0.5f, 0.2f, 0.25f}, 0.1f}}};
  s.fluid.volumes[0].velocity = {0.5f, 0, 0};
  s.fluid.volumes.push_back({Box{{0.1f, 0.6f, 0.1f}, {0.3f, 0.7f, 0.2f}}, {0, -1, 0}});
  Simulation simulation(s);
  simulation.advance_to(0);
  const Frame frame = simulation.frame();
  const InitialParticles initial = fill_volumes(s);
  REQUIRE_FALSE(initial.loose.empty());
  std::vector<char> is_loose(frame.ids.size());
  for (const std::uint32_t number : initial.loose)
    is_loose[number] = 1;
  float furthest = 0;
  for (std::size_t i = 0; i < frame.ids.size(); ++i) {
    const std::uint32_t id = frame.ids[i];
    CHECK(frame.velocities[i] == initial.velocities[id]);
    const float way = glm::distance(frame.positions[i], initial.positions[id]);
    if (is_loose[id])
      furthest = std::max(furthest, way);
    else if (initial.positions[id].y > 0.5f)
      CHECK(way == 0);
  }
  CHECK(furthest > 0.001f);
  CHECK(furthest < 0.05f);
}

}  // namespace placement_tests
