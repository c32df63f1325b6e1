// Liquid at rest, and liquid that comes to rest.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "sim/run/simulation.hpp"
#include "sim/start/initial.hpp"

namespace rest_tests {

using namespace spindrift::sim;

namespace {

constexpr double depth = 1, gravity = 9.81, density = 1000;

/// A tank one metre deep, of a liquid thick enough to calm down in a second.
Settings tank(SolverType solver) {
  Settings s;
  s.solver.type = solver;
  s.solver.mean_compression = 1e-4f;
  s.fluid.spacing = 0.05f;
  s.fluid.viscosity = 5;
  s.domain = {{0, 0, 0}, {0.5f, 1.5f, 0.5f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.5f, 1, 0.5f}}}};
  return s;
}

/// Relative L2 error of the pressure over depth against ρg(h − y): layers one spacing thick, each
/// averaged over its particles and over the frames given.
double hydrostatic_error(const std::vector<Frame>& frames, double spacing) {
  const auto layers = static_cast<std::size_t>(std::lround(depth / spacing));
  std::vector<double> sum(layers, 0.), exact(layers, 0.), count(layers, 0.);
  for (const Frame& frame : frames)
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
      const double y = frame.positions[i].y;
      const std::size_t k = std::min(layers - 1, static_cast<std::size_t>(y / spacing));
      sum[k] += frame.pressures[i];
      exact[k] += density * gravity * (depth - y);
      count[k] += 1;
    }
  double error = 0, norm = 0;
  for (std::size_t k = 0; k < layers; ++k) {
    if (count[k] == 0)
      continue;
    error += std::pow((sum[k] - exact[k]) / count[k], 2);
    norm += std::pow(exact[k] / count[k], 2);
  }
  return std::sqrt(error / norm);
}

}  // namespace

TEST_CASE("a tank comes to rest with hydrostatic pressure", "[slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Simulation simulation(tank(solver));
  const FrameStatistics start = simulation.advance_to(0);
  FrameStatistics end = simulation.advance_to(1.5);
  std::vector<Frame> frames;
  for (int k = 1; k <= 20; ++k) {
    end = simulation.advance_to(1.5 + k / 30.);
    frames.push_back(simulation.frame());
  }
  const double error = hydrostatic_error(frames, 0.05);
  CAPTURE(error, end.kinetic_energy / start.potential_energy);
  CHECK(error < 0.05);
  CHECK(end.kinetic_energy < 3e-4 * start.potential_energy);
  CHECK(end.kinetic_energy + end.potential_energy <= start.potential_energy);
  CHECK(end.contacts == 0);
  float top = 0;
  for (const glm::vec3 p : frames.back().positions)
    top = std::max(top, p.y);
  CHECK(top == Approx(depth - 0.025).margin(0.05));
}

TEST_CASE("steps that change length from one to the next leave a tank at rest") {
  Settings s = tank(SolverType::pcisph);
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
  Settings s = tank(SolverType::pcisph);
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

TEST_CASE("water dropped into a corner stays inside, keeps its number and its density") {
  Settings s;
  s.fluid.spacing = 0.05f;
  s.domain = {{0, 0, 0}, {1, 1.5f, 0.6f}};
  s.fluid.volumes = {{Box{{0.4f, 0.8f, 0}, {1, 1.4f, 0.6f}}, {2, -2, 1}}};
  s.obstacles = {{Sphere{{0.4f, 0.2f, 0.3f}, 0.2f}}};
  s.solver.max_compression = 0.01f;
  Simulation simulation(s);
  const FrameStatistics start = simulation.advance_to(0);
  const double energy = start.kinetic_energy + start.potential_energy;
  for (int k = 1; k <= 30; ++k) {
    const FrameStatistics f = simulation.advance_to(k / 30.);
    CHECK(f.max_compression <= 0.011);
    CHECK(f.mean_compression <= 0.001 * 1.05);
    CHECK(f.kinetic_energy + f.potential_energy <= energy);
  }
  const Frame frame = simulation.frame();
  CHECK(frame.positions.size() == fill_volumes(s).positions.size());
  for (const glm::vec3 p : frame.positions) {
    CHECK(glm::all(glm::greaterThanEqual(p, s.domain.min)));
    CHECK(glm::all(glm::lessThanEqual(p, s.domain.max)));
    CHECK(glm::length(p - glm::vec3(0.4f, 0.2f, 0.3f)) >= 0.2f - 1e-5f);
  }
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
