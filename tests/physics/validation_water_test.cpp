// Against solutions on paper: water at rest, and a standing wave.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "invariants.hpp"

namespace validation_water_tests {

using namespace spindrift::sim;
using namespace spindrift::test;

namespace {

constexpr double gravity = 9.81, density = 1000;

struct Tank {
  SolverType solver = SolverType::pcisph;
  PressureKernel kernel = PressureKernel::cubic;
  double depth = 1, width = 0.5, spacing = 0.05;  // m
};

/// Water at rest.
Settings settings_of(const Tank& tank) {
  Settings s;
  s.solver.type = tank.solver;
  s.solver.pressure_kernel = tank.kernel;
  s.solver.mean_compression = 1e-4f;
  s.fluid.spacing = static_cast<float>(tank.spacing);
  s.fluid.viscosity = 5;  // calms down in a second or two
  const auto width = static_cast<float>(tank.width), depth = static_cast<float>(tank.depth);
  s.domain = {{0, 0, 0}, {width, 1.2f * depth, width}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {width, depth, width}}}};
  return s;
}

struct Rest {
  double pressure_error = 0;  ///< L2 over depth, relative, against ρg(h − y)
  double kinetic = 0;         ///< kinetic energy left, of the potential energy
  double gained = 0;          ///< energy, of that at the start
  double surface = 0;         ///< height of the surface, m
  double iterations = 0;      ///< a step
  std::int64_t contacts = 0;  ///< particles that surfaces stopped in the last frame
};

/// Lets a tank calm down for two seconds, then averages pressure over layers one spacing thick and
/// 60 frames, a second.
Rest at_rest(const Settings& s, double depth) {
  constexpr double calm = 2;
  const double spacing = s.fluid.spacing;
  const auto layers = static_cast<std::size_t>(std::lround(depth / spacing));
  std::vector<double> sum(layers, 0.), exact(layers, 0.), count(layers, 0.);
  Simulation simulation(s);
  const double start = simulation.advance_to(0).potential_energy;
  FrameStatistics f = simulation.advance_to(calm);
  double steps = f.steps, iterations = static_cast<double>(f.iterations), top = 0;
  for (int k = 1; k <= 60; ++k) {
    f = simulation.advance_to(calm + k / 60.);
    steps += f.steps;
    iterations += static_cast<double>(f.iterations);
    const Frame frame = simulation.frame();
    top = 0;
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
      const double y = frame.positions[i].y;
      top = std::max(top, y);
      const auto layer = std::min(layers - 1, static_cast<std::size_t>(y / spacing));
      sum[layer] += frame.pressures[i];
      exact[layer] += density * gravity * (depth - y);
      count[layer] += 1;
    }
  }
  double error = 0, norm = 0;
  for (std::size_t k = 0; k < layers; ++k)
    if (count[k] > 0) {
      error += std::pow((sum[k] - exact[k]) / count[k], 2);
      norm += std::pow(exact[k] / count[k], 2);
    }
  return {.pressure_error = std::sqrt(error / norm),
          .kinetic = f.kinetic_energy / f.potential_energy,
          .gained = (f.kinetic_energy + f.potential_energy) / start - 1,
          .surface = top + 0.5 * spacing,
          .iterations = iterations / steps,
          .contacts = f.contacts};
}

Rest measured(const Tank& tank) {
  const Settings s = settings_of(tank);
  const Rest r = at_rest(s, tank.depth);
  record(fmt::format("rest | {:g} | {:g} | {:g} | {} | {} | {:.2f} | {:.2g} | {:.3f} | {:.1f}",
                     tank.depth, tank.width, tank.spacing,
                     tank.solver == SolverType::pcisph ? "pcisph" : "sph",
                     tank.kernel == PressureKernel::cubic ? "cubic" : "spiky",
                     100 * r.pressure_error, r.kinetic, r.surface, r.iterations));
  CHECK(r.kinetic < 3e-4);
  CHECK(r.gained <= 0);
  CHECK(r.contacts == 0);
  CHECK(r.surface == Approx(tank.depth).margin(0.5 * tank.spacing));
  return r;
}

struct Wave {
  double period = 0;  ///< from the first passage through the middle to the third, s
  double lost = 0;    ///< of the amplitude between the crests in it, half a period apart
};

/// The first mode of a tank 1 m long and 0.5 m deep, let go from its crest: water is displaced as
/// in a wave of small amplitude, ξ ∝ ∇(cos kx cosh ky), with k = π/L. The mode moves the centre of
/// mass along x, whose passages through the middle are timed.
Wave standing_wave(SolverType solver, double spacing, double amplitude) {
  constexpr double depth = 0.5, k = std::numbers::pi;
  Settings s;
  s.solver.type = solver;
  s.fluid.spacing = static_cast<float>(spacing);
  s.fluid.viscosity = 0.001f;
  const auto thick = static_cast<float>(4 * spacing);
  s.domain = {{0, 0, 0}, {1, 0.8f, thick}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {1, static_cast<float>(depth), thick}}}};
  Frame start = Simulation(s).frame();
  const double scale = amplitude / std::sinh(k * depth);
  for (glm::vec3& p : start.positions) {
    const double x = p.x, y = p.y;
    p.x -= static_cast<float>(scale * std::sin(k * x) * std::cosh(k * y));
    p.y += static_cast<float>(scale * std::cos(k * x) * std::sinh(k * y));
  }
  Simulation simulation(s, start);
  constexpr double frame = 0.01;
  std::vector<double> crossings, peaks;
  double before = 0, peak = 0;
  for (double time = 0; crossings.size() < 3 && time < 3; time += frame) {
    simulation.advance_to(time);
    double center = -0.5;
    const Frame now = simulation.frame();
    for (const glm::vec3 p : now.positions)
      center += double{p.x} / static_cast<double>(now.positions.size());
    if (time > 0 && before * center < 0) {
      crossings.push_back(time - frame * center / (center - before));
      peaks.push_back(peak);
      peak = 0;
    }
    peak = std::max(peak, std::abs(center));
    before = center;
  }
  REQUIRE(crossings.size() == 3);
  return {crossings[2] - crossings[0], 1 - peaks[2] / peaks[1]};
}

double wave_error(SolverType solver, double spacing, double amplitude) {
  const Wave wave = standing_wave(solver, spacing, amplitude);
  const double k = std::numbers::pi;
  const double exact = 2 * k / std::sqrt(gravity * k * std::tanh(0.5 * k));
  const double error = wave.period / exact - 1;
  record(fmt::format("wave | {} | {:g} | {:g} | {:.4f} | {:.4f} | {:+.2f} | {:.0f}",
                     solver == SolverType::pcisph ? "pcisph" : "sph", spacing, amplitude, exact,
                     wave.period, 100 * error, 100 * wave.lost));
  return std::abs(error);
}

}  // namespace

TEST_CASE("validation: a tank one metre deep has hydrostatic pressure", "[validation][slow]") {
  const Tank tank = GENERATE(Tank{SolverType::pcisph, PressureKernel::cubic},
                             Tank{SolverType::sph, PressureKernel::spiky});
  CHECK(measured(tank).pressure_error < 0.02);
}

TEST_CASE("validation: narrow and coarse tanks have hydrostatic pressure", "[validation][slow]") {
  const Tank tank = GENERATE(Tank{.width = 0.3}, Tank{.spacing = 0.1});
  CHECK(measured(tank).pressure_error < 0.02);
}

TEST_CASE("validation: a column four metres tall has hydrostatic pressure", "[validation][slow]") {
  CHECK(measured({.depth = 4, .width = 1, .spacing = 0.1}).pressure_error < 0.02);
}

// The water at rest is a crystal five particles wide, which the walls' samples hold or push down a
// little, as a silo does its grain, whatever the solver.
TEST_CASE("validation: walls carry little of a column five particles wide", "[validation][slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  CHECK(measured({.solver = solver, .depth = 4, .spacing = 0.1}).pressure_error < 0.04);
}

TEST_CASE("validation: wide tanks and columns have hydrostatic pressure", "[validation][long]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const PressureKernel kernel = GENERATE(PressureKernel::cubic, PressureKernel::spiky);
  CHECK(measured({solver, kernel, 1, 1, 0.05}).pressure_error < 0.02);
  CHECK(measured({solver, kernel, 4, 1, 0.1}).pressure_error < 0.02);
}

// 2 % is the goal, which basic SPH just misses at this spacing (docs/results.md).
TEST_CASE("validation: a standing wave has the period of ω² = gk tanh(kh)", "[validation][slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  CHECK(wave_error(solver, 0.05, 0.08) < 0.025);
}

TEST_CASE("validation: a finer standing wave has the period of ω² = gk tanh(kh)",
          "[validation][long]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  CHECK(wave_error(solver, 0.025, 0.06) < 0.02);
}

}  // namespace validation_water_tests
