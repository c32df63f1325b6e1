// Viscous flow against exact solutions.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sim/run/simulation.hpp"

namespace viscosity_tests {

using namespace spindrift::sim;
using glm::dvec3;

namespace {

constexpr double gravity = 9.81, density = 1000;

/// Velocity of a steady flow through a square duct of the given width under a force along it, m/s,
/// at (x, z) from its corner (White, Viscous Fluid Flow, eq. 3-48 has the series).
double duct_velocity(double x, double z, double width, double kinematic_viscosity) {
  const double half = width / 2, pi = std::numbers::pi;
  double sum = 0;
  for (int i = 1; i < 60; i += 2)
    sum += (i % 4 == 1 ? 1 : -1) / std::pow(i, 3) *
           (1 - std::cosh(i * pi * (z - half) / width) / std::cosh(i * pi / 2)) *
           std::cos(i * pi * (x - half) / width);
  return 16 * half * half / (pi * pi * pi) * gravity / kinematic_viscosity * sum;
}

/// Liquid that falls through a square duct and sticks to its walls.
Settings duct(float viscosity, float width, int across) {
  Settings s;
  s.fluid.spacing = width / static_cast<float>(across);
  s.fluid.viscosity = s.fluid.wall_viscosity = viscosity;
  s.domain = {{0, 0, 0}, {width, 10 * width, width}};
  s.fluid.volumes = {{Box{{0, 6.5f * width, 0}, {width, 10 * width - s.fluid.spacing, width}}}};
  return s;
}

/// Relative L2 error of the velocities against the duct's, half a duct's width and more away from
/// the ends of the liquid.
double duct_error(const Settings& s, double time) {
  Simulation simulation(s);
  simulation.advance_to(time);
  const Frame frame = simulation.frame();
  const double width = s.domain.max.x;
  float low = 1e9f, high = -1e9f;
  for (const glm::vec3 p : frame.positions) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  double error = 0, norm = 0;
  for (std::size_t i = 0; i < frame.positions.size(); ++i) {
    const glm::vec3 p = frame.positions[i];
    if (p.y < low + width || p.y > high - width)
      continue;
    const double exact = -duct_velocity(p.x, p.z, width, double{s.fluid.viscosity} / density);
    error += std::pow(frame.velocities[i].y - exact, 2);
    norm += exact * exact;
  }
  return std::sqrt(error / norm);
}

}  // namespace

TEST_CASE("liquid that sticks to a duct's walls falls through it as theory says", "[slow]") {
  const double coarse = duct_error(duct(50, 0.1f, 10), 0.06);
  const double fine = duct_error(duct(50, 0.1f, 20), 0.06);
  CAPTURE(coarse, fine);
  CHECK(coarse < 0.05);
  CHECK(fine < 0.02);
}

TEST_CASE("liquid that slips along a duct's walls falls freely, however thick it is") {
  Settings s = duct(1000, 0.1f, 8);
  s.fluid.wall_viscosity = 0;
  Simulation simulation(s);
  simulation.advance_to(0.1);
  const Frame frame = simulation.frame();
  for (const glm::vec3 v : frame.velocities)
    CHECK(double{v.y} == Approx(-gravity * (0.1 - 0.5 * frame.last_time_step)).epsilon(1e-3));
}

TEST_CASE("the implicit step gives what many explicit ones give", "[slow]") {
  // Shear decays in a block without walls near it; 2 ms are four times the longest explicit step.
  const auto decayed = [](float time_step) {
    Settings s;
    s.fluid.spacing = 0.05f;
    s.fluid.viscosity = 100;
    s.forces.gravity = glm::vec3(0);
    s.domain = {{-2, -2, -2}, {2, 2, 2}};
    s.fluid.volumes = {{Box{{-0.3f, -0.3f, -0.2f}, {0.3f, 0.3f, 0}}, {0.1f, 0, 0}},
                       {Box{{-0.3f, -0.3f, 0}, {0.3f, 0.3f, 0.2f}}, {-0.1f, 0, 0}}};
    s.solver.max_time_step = time_step;
    Simulation simulation(s);
    simulation.advance_to(0.2);
    glm::dvec3 momentum(0);
    double shear = 0;
    const Frame frame = simulation.frame();
    for (std::size_t i = 0; i < frame.positions.size(); ++i) {
      momentum += glm::dvec3(frame.velocities[i]);
      shear -= double{frame.velocities[i].x} * frame.positions[i].z;
    }
    CHECK(glm::length(momentum) < 1e-5 * 0.1 * static_cast<double>(frame.positions.size()));
    return shear;
  };
  const double start = 0.1 * 0.1 * 12 * 12 * 8;  // Σ |v x| of the blocks
  const double by_small_steps = decayed(2.5e-4f), by_large_ones = decayed(2e-3f);
  CAPTURE(by_small_steps / start, by_large_ones / start);
  CHECK(by_small_steps < 0.9 * start);
  CHECK(by_large_ones == Approx(by_small_steps).epsilon(0.02));
}

TEST_CASE("thick liquid needs no small steps, and creeps") {
  Settings s;
  s.fluid.spacing = 0.05f;
  s.fluid.viscosity = s.fluid.wall_viscosity = 1000;
  s.domain = {{0, 0, 0}, {1, 0.8f, 0.3f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.4f, 0.5f, 0.3f}}}};
  Simulation simulation(s);
  const FrameStatistics start = simulation.advance_to(0);
  const FrameStatistics end = simulation.advance_to(0.3);
  CHECK(end.steps < 80);
  CHECK(end.max_speed < 1);
  CHECK(end.kinetic_energy + end.potential_energy < start.potential_energy);
  CHECK(end.kinetic_energy < 0.02 * (start.potential_energy - end.potential_energy));
}

}  // namespace viscosity_tests
