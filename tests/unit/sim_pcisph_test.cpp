// One PCISPH step on few particles against the algorithm written out plainly in double precision.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <vector>

#include "sim/core/kernels.hpp"
#include "sim/core/lattice.hpp"
#include "sim/run/simulation.hpp"
#include "sim/start/initial.hpp"
#include "sim/step/time_step.hpp"

namespace sim_pcisph_tests {

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
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.3f, 0.3f, 0.3f}}, {2, 0, 0}},
                     {Box{{0.24f, 0.02f, 0.01f}, {0.54f, 0.32f, 0.31f}}, {-3, 1, 0}}};
  return s;
}

struct PlainResult {
  std::vector<dvec3> positions, velocities;
  std::vector<double> pressures, densities;
};

/// Solves A x = b by elimination.
std::vector<double> solved(std::vector<std::vector<double>> a, std::vector<double> b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t i = k + 1; i < n; ++i) {
      const double f = a[i][k] / a[k][k];
      for (std::size_t j = k; j < n; ++j)
        a[i][j] -= f * a[k][j];
      b[i] -= f * b[k];
    }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j)
      b[k] -= a[k][j] * b[j];
    b[k] /= a[k][k];
  }
  return b;
}

/// The cells of the neighbour search that hold particles, and the cell of each.
struct PlainCells {
  double size;  ///< m
  dvec3 origin;
  std::vector<glm::ivec3> cells;
  std::vector<std::size_t> cell_of;

  PlainCells(const Settings& s, const std::vector<dvec3>& x)
      : size(1.05 * 2 * s.fluid.spacing),
        origin(dvec3(s.domain.min) - double{s.fluid.spacing} - 2 * size) {
    for (const dvec3& p : x) {
      const glm::ivec3 c((p - origin) / size);
      const auto at = std::find(cells.begin(), cells.end(), c);
      cell_of.push_back(static_cast<std::size_t>(at - cells.begin()));
      if (at == cells.end())
        cells.push_back(c);
    }
  }
};

/// The pressure that the cells' equation gives each particle where there was none before:
/// conductances summed over all pairs of active particles, a dense matrix, splines written out.
std::vector<double> plain_coarse_pressure(const Settings& s, double dt, const std::vector<dvec3>& x,
                                          const std::vector<double>& error,
                                          const std::vector<bool>& active) {
  const double radius = 2 * double{s.fluid.spacing};
  const auto [cell, origin, cells, cell_of] = PlainCells(s, x);
  const auto shape = [&](double squared) {
    return squared < radius * radius ? std::pow(1 - squared / (radius * radius), 2) : 0.;
  };
  double all = 0, xx = 0, ax = 0;
  for_lattice_points(s.fluid.spacing, static_cast<float>(radius), [&](const Vec3<float>& p) {
    const double w = shape(double{dot(p, p)});
    all += w;
    xx += w * p.x * p.x;
    ax += w * std::abs(p.x);
  });
  const double scale = 2 / xx;
  const std::size_t n = cells.size();
  std::vector<std::vector<double>> matrix(n, std::vector<double>(n, 0.));
  std::vector<double> lacking(n, 0.), count(n, 0.), sum(n, 0.);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!active[i])
      continue;
    const std::size_t a = cell_of[i];
    lacking[a] += all * scale;
    count[a] += 1;
    sum[a] += error[i];
    for (std::size_t j = 0; j < x.size(); ++j) {
      if (!active[j])
        continue;
      const double w = scale * shape(glm::dot(x[i] - x[j], x[i] - x[j]));
      lacking[a] -= w;
      matrix[a][a] += cell_of[j] == a ? 0 : w;
      matrix[a][cell_of[j]] -= cell_of[j] == a ? 0 : w;
    }
  }
  for (std::size_t a = 0; a < n; ++a) {
    const double full = std::max(1e-9, all * scale * count[a]);
    matrix[a][a] += std::max(0., lacking[a] - 0.03 * full) + 1e-6 * full;
    sum[a] = std::max(0., sum[a]);
  }
  std::vector<double> p = solved(matrix, sum), at(x.size(), 0.);
  for (std::size_t i = 0; i < x.size(); ++i) {
    const dvec3 t = (x[i] - origin) / cell - dvec3(cells[cell_of[i]]) - 0.5;
    const auto spline = [](double u) {
      u = std::abs(u);
      return u < 0.5 ? 0.75 - u * u : (u < 1.5 ? 0.5 * (1.5 - u) * (1.5 - u) : 0.);
    };
    for (int k = 0; k < 27; ++k) {
      const glm::ivec3 o(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1);
      const auto other = std::find(cells.begin(), cells.end(), cells[cell_of[i]] + o);
      const double value =
          other == cells.end() ? p[cell_of[i]] : p[static_cast<std::size_t>(other - cells.begin())];
      at[i] += spline(t.x - o.x) * spline(t.y - o.y) * spline(t.z - o.z) * value;
    }
    at[i] *= 0.3 * cell * ax / xx * s.fluid.rest_density / (dt * dt);
  }
  return at;
}

std::vector<double> plain_densities(const Settings& s, const std::vector<dvec3>& x) {
  const CubicKernel kernel(2 * s.fluid.spacing);
  const double volume = 1 / lattice_kernel_sum(kernel, s.fluid.spacing, 2 * s.fluid.spacing);
  std::vector<double> ratios;
  for (const dvec3& at : x) {
    ratios.push_back(0);
    for (const dvec3& other : x)
      ratios.back() += volume * double{kernel.value(static_cast<float>(glm::length(at - other)))};
  }
  return ratios;
}

/// p's pressure accelerations.
std::vector<dvec3> plain_accelerations(const Settings& s, const std::vector<dvec3>& x,
                                       const std::vector<double>& p) {
  const CubicKernel kernel(2 * s.fluid.spacing);
  const double volume = 1 / lattice_kernel_sum(kernel, s.fluid.spacing, 2 * s.fluid.spacing);
  std::vector<dvec3> acceleration(x.size(), dvec3(0));
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < x.size(); ++j) {
      const dvec3 d = x[i] - x[j];
      if (j != i)
        acceleration[i] -= volume / s.fluid.rest_density * (p[i] + p[j]) *
                           double{kernel.gradient(static_cast<float>(glm::length(d)))} * d;
    }
  return acceleration;
}

/// The part of the compression at the start that the step leaves: 19 parts in 20, as there is no
/// gravity.
std::vector<double> plain_excess(const Settings& s, const std::vector<dvec3>& start) {
  std::vector<double> excess = plain_densities(s, start);
  for (double& e : excess)
    e = 0.95 * std::max(0., e - 1);
  return excess;
}

/// The best combination of the last three iterates, by the normal equations of Anderson's
/// acceleration.
void accelerate(std::vector<std::vector<double>> p, std::vector<std::vector<double>> r,
                std::vector<double>& best_p, std::vector<double>& best_r) {
  const std::size_t steps = std::min<std::size_t>(p.size() - 1, 2), last = p.size() - 1;
  best_p = p[last];
  best_r = r[last];
  if (steps == 0)
    return;
  const auto difference = [&](const std::vector<std::vector<double>>& f, std::size_t k,
                              std::size_t i) { return f[last - k][i] - f[last - k - 1][i]; };
  std::vector<std::vector<double>> normal(steps, std::vector<double>(steps, 0.));
  std::vector<double> right(steps, 0.);
  for (std::size_t i = 0; i < best_p.size(); ++i)
    for (std::size_t a = 0; a < steps; ++a) {
      right[a] += difference(r, a, i) * r[last][i];
      for (std::size_t b = 0; b < steps; ++b)
        normal[a][b] += difference(r, a, i) * difference(r, b, i);
    }
  const std::vector<double> theta = solved(normal, right);
  for (std::size_t i = 0; i < best_p.size(); ++i)
    for (std::size_t a = 0; a < steps; ++a) {
      best_p[i] -= theta[a] * difference(p, a, i);
      best_r[i] -= theta[a] * difference(r, a, i);
    }
}

/// The positions moved on by 0.6 of what is wrong, but at most 0.15 of the tolerance. The pressures
/// that are kept are twice those of a first step.
std::vector<dvec3> plain_eased(const Settings& s, double dt, double delta, std::vector<dvec3> x,
                               const std::vector<double>& ratios, const std::vector<double>& p) {
  const double most = 0.15 * s.solver.max_compression;
  std::vector<double> easing;
  for (std::size_t i = 0; i < x.size(); ++i)
    easing.push_back(0.6 * delta *
                     std::clamp(std::max(ratios[i] - 1, -2 * p[i] / delta), -most, most));
  const std::vector<dvec3> acceleration = plain_accelerations(s, x, easing);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] += dt * dt * acceleration[i];
  return x;
}

/// The step, every pair visited: drift, then a fixed number of corrections, the first of them with
/// the coarse grid's, then the move, and easing.
PlainResult plain_step(const Settings& s, double dt, int iterations, double relaxation) {
  const InitialParticles start = fill_volumes(s);
  const std::size_t n = start.positions.size();
  const double rho = s.fluid.rest_density;
  const float radius = 2 * s.fluid.spacing;
  const CubicKernel kernel(radius);
  const double volume = 1 / lattice_kernel_sum(kernel, s.fluid.spacing, radius);
  const double delta = rho / (dt * dt * volume * volume *
                              lattice_gradient_product(kernel, kernel, s.fluid.spacing, radius));
  PlainResult r;
  std::vector<dvec3> drifted(n), acceleration(n), corrected(n);
  for (std::size_t i = 0; i < n; ++i)
    drifted[i] = dvec3(start.positions[i]) + dt * dvec3(start.velocities[i]);
  std::vector<dvec3> at_start(start.positions.begin(), start.positions.end());
  const std::vector<double> excess = plain_excess(s, at_start);
  std::vector<double> p(n, 0.), best_p, best_r;
  std::vector<std::vector<double>> iterates, residuals;
  for (int k = 0;; ++k) {
    acceleration = plain_accelerations(s, drifted, p);
    for (std::size_t i = 0; i < n; ++i)
      corrected[i] = drifted[i] + dt * dt * acceleration[i];
    r.densities = plain_densities(s, corrected);
    if (k == iterations)
      break;
    iterates.push_back(p);
    residuals.emplace_back();
    for (std::size_t i = 0; i < n; ++i)
      residuals.back().push_back(std::max(r.densities[i] - 1 - excess[i], -p[i] / delta));
    accelerate(iterates, residuals, best_p, best_r);
    std::vector<double> coarse(n, 0.);
    if (k == 0) {
      std::vector<double> error(n);
      std::vector<bool> active(n);
      for (std::size_t i = 0; i < n; ++i) {
        error[i] = r.densities[i] - 1 - excess[i];
        active[i] = r.densities[i] > 0.97;
      }
      coarse = plain_coarse_pressure(s, dt, drifted, error, active);
    }
    for (std::size_t i = 0; i < n; ++i) {
      const double residual = k == 0 ? r.densities[i] - 1 - excess[i] : best_r[i];
      p[i] = std::max(0., best_p[i] + relaxation * delta * residual + coarse[i]);
    }
  }
  for (std::size_t i = 0; i < n; ++i)
    r.velocities.push_back(dvec3(start.velocities[i]) + dt * acceleration[i]);
  r.pressures = p;
  r.positions = plain_eased(s, dt, delta, corrected, r.densities, p);
  r.densities = plain_densities(s, r.positions);
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
  const PlainResult plain = plain_step(s, dt, 4, 0.45);
  const double largest_pressure = *std::max_element(plain.pressures.begin(), plain.pressures.end());
  // The coarse grid is solved to a hundredth.
  for (std::size_t i = 0; i < frame.ids.size(); ++i) {
    const std::uint32_t id = frame.ids[i];
    INFO("particle " << id);
    CHECK(glm::length(dvec3(frame.positions[i]) - plain.positions[id]) < 2e-5);
    CHECK(glm::length(dvec3(frame.velocities[i]) - plain.velocities[id]) < 1e-2);
    CHECK(double{frame.constraint_multipliers[i]} ==
          Approx(plain.pressures[id] * 2).epsilon(1e-2).margin(2e-2 * largest_pressure));
    // Densities are those where the particles end up.
    CHECK(double{frame.densities[i]} / 1000 == Approx(plain.densities[id]).epsilon(2e-4));
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

TEST_CASE(
    "a step that can't converge is repeated smaller, and says so when no step is small enough") {
  Settings s = overlapping_blocks();
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.3f, 0.3f, 0.3f}}, {10, 0, 0}},
                     {Box{{0.32f, 0, 0}, {0.62f, 0.3f, 0.3f}}, {-10, 0, 0}}};
  s.solver.max_iterations = 1;
  s.solver.max_compression = s.solver.mean_compression = 1e-4f;
  s.solver.min_time_step = 1e-3f;
  Simulation simulation(s);
  CHECK_THROWS_WITH(simulation.advance_to(0.1), Catch::Contains("solver.min_time_step"));
}

}  // namespace sim_pcisph_tests
