// Motion that is known exactly.
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/run/simulation.hpp"
#include "sim/start/initial.hpp"

namespace motion_tests {

using namespace spindrift::sim;
using glm::dvec3;

namespace {

struct Sums {
  dvec3 momentum{0}, angular{0};  ///< per mass of a particle
};

Sums sums_of(const Frame& frame) {
  Sums s;
  for (std::size_t i = 0; i < frame.positions.size(); ++i) {
    const dvec3 v(frame.velocities[i]);
    s.momentum += v;
    s.angular += glm::cross(dvec3(frame.positions[i]), v);
  }
  return s;
}

/// Two blocks that collide off centre, in a domain so large that they never reach its walls.
Settings colliding_blocks(SolverType solver) {
  Settings s;
  s.solver.type = solver;
  s.fluid.spacing = 0.05f;
  s.fluid.viscosity = 0.5f;
  s.forces.gravity = glm::vec3(0);
  s.domain = {{-3, -3, -3}, {3, 3, 3}};
  s.fluid.volumes = {{Box{{-0.5f, 0, 0}, {-0.1f, 0.4f, 0.4f}}, {2, 0, 0}},
                     {Box{{0.1f, 0.15f, 0}, {0.5f, 0.55f, 0.4f}}, {-1, 0, 0.5f}}};
  return s;
}

}  // namespace

TEST_CASE("a block falls freely as it must, for every solver and frame rate") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const double step = GENERATE(1. / 30, 1. / 7);
  Settings s;
  s.solver.type = solver;
  s.solver.speed_of_sound = 20;
  s.fluid.spacing = 0.1f;
  s.domain = {{-1, 0, -1}, {1, 12, 1}};
  s.fluid.volumes = {{Box{{-0.3f, 11, -0.3f}, {0.3f, 11.6f, 0.3f}}, {0.5f, 1, 0}}};
  const InitialParticles start = fill_volumes(s);
  Simulation simulation(s);
  double time = 0;
  for (int k = 1; time < 1; ++k) {
    time = k * step;
    simulation.advance_to(time);
  }
  const Frame frame = simulation.frame();
  const dvec3 g(0, -9.81, 0), v0(0.5, 1, 0);
  // Velocities belong to the middle of the last step.
  const dvec3 velocity = v0 + g * (time - 0.5 * frame.last_time_step);
  const dvec3 moved = v0 * time + 0.5 * g * time * time;
  for (std::size_t i = 0; i < frame.ids.size(); ++i) {
    const dvec3 from(start.positions[frame.ids[i]]);
    CHECK(glm::length(dvec3(frame.velocities[i]) - velocity) < 1e-4 * glm::length(velocity));
    CHECK(glm::length(dvec3(frame.positions[i]) - from - moved) < 1e-5 * glm::length(moved) + 1e-5);
  }
}

TEST_CASE("momentum is kept without walls, and angular momentum nearly", "[slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Simulation simulation(colliding_blocks(solver));
  simulation.advance_to(0);
  const Sums before = sums_of(simulation.frame());
  const FrameStatistics end = simulation.advance_to(0.6);
  const Sums after = sums_of(simulation.frame());
  // Drift relative to the momentum that changes hands, not to the sum, which could be small.
  const double scale = 2. * 512;
  CHECK(glm::length(after.momentum - before.momentum) < 1e-5 * scale);
  CHECK(glm::length(after.angular - before.angular) < 0.02 * glm::length(before.angular));
  CHECK(end.max_speed < 4);
}

TEST_CASE("a collision never makes energy", "[slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Simulation simulation(colliding_blocks(solver));
  double energy = simulation.advance_to(0).kinetic_energy;
  for (int k = 1; k <= 30; ++k) {
    const double next = simulation.advance_to(k * 0.02).kinetic_energy;
    CHECK(next <= energy * (solver == SolverType::pcisph ? 1.0005 : 1.01));
    energy = next;
  }
}

}  // namespace motion_tests
