// Liquid at rest, and liquid that comes to rest. Its pressure is in validation_water_test.cpp.
#include <algorithm>
#include <catch2/catch.hpp>

#include "hard_cases.hpp"

namespace rest_tests {

using namespace spindrift::sim;
using namespace spindrift::test;

namespace {

/// A tank one metre deep, of a liquid thick enough to calm down in a second.
Settings tank() {
  Settings s;
  s.solver.mean_compression = 1e-4f;
  s.fluid.spacing = 0.05f;
  s.fluid.viscosity = 5;
  s.domain = {{0, 0, 0}, {0.5f, 1.5f, 0.5f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.5f, 1, 0.5f}}}};
  return s;
}

}  // namespace

TEST_CASE("steps that change length from one to the next leave a tank at rest") {
  Settings s = tank();
  Simulation simulation(s);
  simulation.advance_to(0.5);
  double time = 0.5, largest = 0;
  for (int k = 0; k < 60; ++k) {
    time += k % 2 == 0 ? 1.2e-3 : 4.5e-3;  // one step each
    largest = std::max(largest, simulation.advance_to(time).max_speed);
  }
  CHECK(largest < 0.5);
}

TEST_CASE("a tank at rest gains no energy, however short the steps", "[slow]") {
  Settings s = tank();
  s.solver.mean_compression = 1e-3f;
  s.fluid.viscosity = 0.01f;
  s.solver.max_time_step = GENERATE(2e-4f, 1e-3f, 5e-3f);
  Simulation simulation(s);
  const FrameStatistics start = simulation.advance_to(0);
  double most = 0;
  for (int k = 1; k <= 10; ++k) {
    const FrameStatistics f = simulation.advance_to(0.02 * k);
    most = std::max(most, f.kinetic_energy + f.potential_energy);
  }
  CAPTURE(s.solver.max_time_step);
  CHECK(most <= 1.0005 * start.potential_energy);
}

TEST_CASE("water dropped into a corner stays inside, keeps its number and its density", "[slow]") {
  Settings s;
  s.fluid.spacing = 0.05f;
  s.domain = {{0, 0, 0}, {1, 1.5f, 0.6f}};
  s.fluid.volumes = {{Box{{0.4f, 0.8f, 0}, {1, 1.4f, 0.6f}}, {2, -2, 1}}};
  s.obstacles = {{Sphere{{0.4f, 0.2f, 0.3f}, 0.2f}}};
  s.solver.max_compression = 0.01f;
  const Invariants end = watch(s, 1, 30);
  check("water dropped into a corner", s, end, {.energy = 1e-3});
  CHECK(end.end.positions.size() == fill_volumes(s).positions.size());
}

TEST_CASE("a pool with a ball in it is settled once, and goes on from there") {
  Settings s;
  s.fluid.spacing = 0.05f;
  s.domain = {{0, 0, 0}, {0.5f, 1, 0.5f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.5f, 0.5f, 0.5f}}}};
  s.obstacles = {{Sphere{{0.25f, 0.2f, 0.25f}, 0.15f}}};
  Simulation simulation(s);
  const FrameStatistics start = simulation.advance_to(0);
  CHECK(start.mean_compression < s.solver.mean_compression);
  CHECK(start.max_compression < s.solver.max_compression);
  const Frame first = simulation.frame();
  const FrameStatistics next = simulation.advance_to(0.02);
  CHECK(next.mean_compression <= s.solver.mean_compression);
  CHECK(next.max_compression <= s.solver.max_compression);
  Simulation resumed(s, first);
  resumed.advance_to(0.02);
  CHECK(resumed.frame().positions == simulation.frame().positions);
}

}  // namespace rest_tests
