// One PCISPH step on few particles against the algorithm written out plainly in double precision,
// and what a step must keep to.
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "sim/kernels.hpp"
#include "sim/lattice.hpp"
#include "sim/simulation.hpp"

using namespace spindrift::sim;
using glm::dvec3;

namespace {

/// Two blocks of 3 × 3 × 3 that overlap, far from the walls, without gravity and viscosity.
Settings overlapping_blocks() {
  Settings s;
  s.fluid.spacing = 0.1f;
  s.fluid.viscosity = 0;
  s.forces.gravity = glm::vec3(0);
  s.domain = {{-2, -2, -2}, {2, 2, 2}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.3f, 0.3f, 0.3f}}, {0.2f, 0, 0}},
                     {Box{{0.24f, 0.02f, 0.01f}, {0.54f, 0.32f, 0.31f}}, {-0.3f, 0.1f, 0}}};
  return s;
}

struct PlainResult {
  std::vector<dvec3> positions, velocities;
  std::vector<double> pressures, densities;
};

/// The step as in the paper, every pair visited: drift, then a fixed number of corrections with the
/// momentum of the accelerated gradient method, then the move.
PlainResult plain_step(const Settings& s, double dt, int iterations, double relaxation) {
  const InitialParticles start = fill_volumes(s);
  const std::size_t n = start.positions.size();
  const double rho = s.fluid.rest_density;
  const float radius = 2 * s.fluid.spacing;
  const CubicKernel kernel(radius);
  const double volume = 1 / lattice_kernel_sum(kernel, s.fluid.spacing, radius);
  const double delta = relaxation * rho /
                       (dt * dt * volume * volume *
                        lattice_gradient_product(kernel, kernel, s.fluid.spacing, radius));
  PlainResult r;
  std::vector<dvec3> drifted(n), acceleration(n), corrected(n);
  for (std::size_t i = 0; i < n; ++i)
    drifted[i] = dvec3(start.positions[i]) + dt * dvec3(start.velocities[i]);
  std::vector<double> p(n, 0.), before(n, 0.);
  r.densities.resize(n);
  double t = 1;
  for (int k = 0;; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      acceleration[i] = dvec3(0);
      for (std::size_t j = 0; j < n; ++j) {
        const dvec3 x = drifted[i] - drifted[j];
        const auto dist = static_cast<float>(glm::length(x));
        if (j != i)
          acceleration[i] -= volume / rho * (p[i] + p[j]) * double{kernel.gradient(dist)} * x;
      }
    }
    for (std::size_t i = 0; i < n; ++i)
      corrected[i] = drifted[i] + dt * dt * acceleration[i];
    for (std::size_t i = 0; i < n; ++i) {
      r.densities[i] = 0;
      for (std::size_t j = 0; j < n; ++j)
        r.densities[i] +=
            volume *
            double{kernel.value(static_cast<float>(glm::length(corrected[i] - corrected[j])))};
    }
    if (k == iterations)
      break;
    const double t_next = 0.5 * (1 + std::sqrt(1 + 4 * t * t)), weight = (t - 1) / t_next;
    t = t_next;
    double progress = 0;
    for (std::size_t i = 0; i < n; ++i) {
      const double next = std::max(0., p[i] + delta * (r.densities[i] - 1));
      progress += (r.densities[i] - 1) * (next - before[i]);
      p[i] = std::max(0., next + weight * (next - before[i]));
      before[i] = next;
    }
    if (progress < 0)
      t = 1;
  }
  r.positions = corrected;
  for (std::size_t i = 0; i < n; ++i)
    r.velocities.push_back(dvec3(start.velocities[i]) + dt * acceleration[i]);
  r.pressures = p;
  return r;
}

}  // namespace

TEST_CASE("a PCISPH step of few particles is the algorithm's, by hand") {
  Settings s = overlapping_blocks();
  s.solver.min_iterations = s.solver.max_iterations = 4;
  s.solver.max_compression = s.solver.mean_compression = 0.5f;
  const double dt = 0.002;
  s.solver.max_time_step = static_cast<float>(dt);
  Simulation simulation(s);
  const FrameStatistics statistics = simulation.advance_to(dt);
  REQUIRE(statistics.steps == 1);
  REQUIRE(statistics.iterations == 4);
  const Frame frame = simulation.frame();
  const PlainResult plain = plain_step(s, dt, 4, 0.36);
  double largest_pressure = 0;
  for (std::size_t i = 0; i < frame.ids.size(); ++i) {
    const std::uint32_t id = frame.ids[i];
    INFO("particle " << id);
    CHECK(glm::length(dvec3(frame.positions[i]) - plain.positions[id]) < 2e-6);
    CHECK(glm::length(dvec3(frame.velocities[i]) - plain.velocities[id]) < 1e-3);
    CHECK(double{frame.pressures[i]} == Approx(plain.pressures[id] * 2).epsilon(2e-3).margin(1));
    // The last prediction is where the particles end up: its density is the one measured there.
    CHECK(double{frame.densities[i]} / 1000 == Approx(plain.densities[id]).epsilon(1e-4));
    largest_pressure = std::max(largest_pressure, plain.pressures[id]);
  }
  CHECK(largest_pressure > 1000);  // the blocks do push
}

TEST_CASE("pressure is released when the compression that made it is gone") {
  Simulation simulation(overlapping_blocks());
  simulation.advance_to(0.002);
  float early = 0;
  for (const float p : simulation.frame().pressures)
    early = std::max(early, p);
  CHECK(early > 100);
  simulation.advance_to(1);  // the blocks have flown apart
  float late = 0;
  for (const float p : simulation.frame().pressures)
    late = std::max(late, p);
  CHECK(late < 0.01f * early);
}

TEST_CASE("a tighter tolerance gives a smaller measured error") {
  Settings s;
  s.fluid.spacing = 0.06f;
  s.domain = {{0, 0, 0}, {1.2f, 1.2f, 0.6f}};
  s.fluid.volumes = {{Box{{0, 0.3f, 0}, {0.6f, 0.9f, 0.6f}}}};
  const auto measured = [&](float mean, float largest) {
    s.solver.mean_compression = mean;
    s.solver.max_compression = largest;
    Simulation simulation(s);
    FrameStatistics worst;
    for (int k = 1; k <= 15; ++k) {
      const FrameStatistics f = simulation.advance_to(k * 0.03);
      worst.mean_compression = std::max(worst.mean_compression, f.mean_compression);
      worst.max_compression = std::max(worst.max_compression, f.max_compression);
    }
    return worst;
  };
  const FrameStatistics loose = measured(0.003f, 0.05f), tight = measured(0.0002f, 0.01f);
  CHECK(loose.mean_compression <= 0.003 * 1.1);
  CHECK(loose.max_compression <= 0.05 * 1.1);
  CHECK(tight.mean_compression <= 0.0002 * 1.1);
  CHECK(tight.max_compression <= 0.01 * 1.1);
  CHECK(tight.mean_compression < 0.2 * loose.mean_compression);
}

TEST_CASE(
    "a step that can't converge is repeated smaller, and says so when no step is small enough") {
  Settings s = overlapping_blocks();
  s.solver.max_iterations = 1;
  s.solver.max_compression = s.solver.mean_compression = 1e-4f;
  s.solver.min_time_step = 1e-4f;
  Simulation simulation(s);
  CHECK_THROWS_WITH(simulation.advance_to(0.1), Catch::Contains("solver.min_time_step"));
}

TEST_CASE("a scene without particles is refused") {
  Settings s;
  s.fluid.volumes.clear();
  CHECK_THROWS_AS(Simulation(s), std::invalid_argument);
}
