// What probes read in liquids whose state is known.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/run/probes.hpp"

namespace probes_tests {

using namespace spindrift::sim;

TEST_CASE("probes in a tank at rest read its height, ρgh and its energy", "[slow]") {
  constexpr double depth = 1;
  Settings s;
  s.solver.mean_compression = 1e-4f;
  s.fluid.spacing = 0.05f;
  s.fluid.viscosity = 5;
  s.domain = {{0, 0, 0}, {0.5f, 1.5f, 0.5f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.5f, 1, 0.5f}}}};
  Simulation simulation(s);
  simulation.advance_to(1.5);
  constexpr int frames = 20;
  double floor = 0, middle = 0;
  for (int k = 1; k <= frames; ++k) {
    const FrameStatistics statistics = simulation.advance_to(1.5 + k / 30.);
    const Frame frame = simulation.frame();
    for (const float x : {0.f, 0.2f, 0.25f})
      CHECK(surface_height(frame, s.fluid.spacing, s.domain, x, 0.25f) ==
            Approx(depth).margin(0.5 * double{s.fluid.spacing}));
    floor += pressure_at(frame, s.fluid.spacing, {0.25f, 0, 0.25f}) / frames;
    middle += pressure_at(frame, s.fluid.spacing, {0, 0.5f, 0.25f}) / frames;
    const Energy energy = energy_of(frame, s);
    CHECK(energy.kinetic == Approx(statistics.kinetic_energy).epsilon(1e-5).margin(1e-9));
    CHECK(energy.potential == Approx(statistics.potential_energy).epsilon(1e-5));
  }
  // At the floor it is the pressure half a spacing above.
  CHECK(floor == Approx(1000 * 9.81 * (depth - 0.025)).epsilon(0.02));
  CHECK(middle == Approx(1000 * 9.81 * 0.5).epsilon(0.02));
}

TEST_CASE("the front of a dam break runs on without turning back, and arrives at the wall") {
  Settings s;
  s.fluid.spacing = 0.04f;
  s.domain = {{0, 0, 0}, {1.6f, 1, 0.32f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.4f, 0.8f, 0.32f}}}};
  Simulation simulation(s);
  double last = 0.4;
  for (int k = 0; k <= 20; ++k) {
    simulation.advance_to(k / 30.);
    const double front = front_position(simulation.frame(), s.fluid.spacing, Direction::plus_x);
    CAPTURE(k, last);
    // What hits the wall is pressed against it, and springs back.
    CHECK(front > std::min(last, 1.6) - 0.1 * double{s.fluid.spacing});
    last = front;
  }
  CHECK(last == Approx(1.6).margin(0.5 * double{s.fluid.spacing}));
  CHECK(front_position(simulation.frame(), s.fluid.spacing, Direction::minus_x) ==
        Approx(0).margin(0.5 * double{s.fluid.spacing}));
}

}  // namespace probes_tests
