// Densities by their definition, in double precision, with none of the program's kernels, neighbour
// lists and loops.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "sim/boundary/walls.hpp"
#include "sim/start/initial.hpp"

namespace spindrift::test {

/// The cubic spline W(r) of Monaghan 2005, 1/m³, in the form in which it is printed.
/// @param radius where it ends, m
inline double cubic_spline(double r, double radius) {
  const double q = r / radius, scale = 8 / (std::numbers::pi * radius * radius * radius);
  if (q < 0.5)
    return scale * (1 - 6 * q * q + 6 * q * q * q);
  return q < 1 ? scale * 2 * (1 - q) * (1 - q) * (1 - q) : 0;
}

/// Σ W over a lattice without end, whose points are a spacing apart, around one of them, 1/m³.
inline double lattice_sum(double spacing, double radius) {
  double sum = 0;
  for (int i = -2; i <= 2; ++i)
    for (int j = -2; j <= 2; ++j)
      for (int k = -2; k <= 2; ++k)
        sum += cubic_spline(spacing * std::sqrt(i * i + j * j + k * k), radius);
  return sum;
}

/// Recomputes the densities of a scene without emitters from the positions of its particles. The
/// places and volumes of the boundary particles are the program's; tests/unit/sim_boundary_test.cpp
/// holds them against what a flat wall has to contribute.
class PlainDensities {
 public:
  explicit PlainDensities(const sim::Settings& settings)
      : settings_(sim::as_filled(settings)),
        radius_(2 * settings_.fluid.spacing),
        volume_(1 / lattice_sum(double{settings_.fluid.spacing}, double{radius_})),
        walls_(settings_, sim::grid_over(settings_, radius_), radius_, nullptr) {}

  /// ρ/ρ₀ of each particle of a frame: Σ V W over the particles and the boundary particles within
  /// the support radius, itself among them. They are found among all points sorted along the
  /// domain's longest edge.
  std::vector<double> ratios(const sim::Frame& frame) {
    const glm::vec3 size = settings_.domain.max - settings_.domain.min;
    const int axis = size.x >= std::max(size.y, size.z) ? 0 : (size.y >= size.z ? 1 : 2);
    std::vector<Point> points;
    for (const glm::vec3& p : frame.positions)
      points.push_back({p, volume_});
    walls_.move(executor_, frame.time, frame.time);
    for (std::uint32_t b = 0; b < boundary().count(); ++b)
      points.push_back({boundary().position(b), boundary().volume(b)});
    const auto before = [&](const Point& a, const Point& b) {
      return a.position[axis] < b.position[axis];
    };
    std::sort(points.begin(), points.end(), before);
    std::vector<double> ratios;
    for (const glm::vec3& p : frame.positions) {
      glm::vec3 low = p, high = p;
      low[axis] -= radius_;
      high[axis] += radius_;
      double sum = 0;
      for (auto q = std::lower_bound(points.begin(), points.end(), Point{low}, before);
           q != points.end() && !before(Point{high}, *q); ++q)
        if (const glm::vec3 apart = q->position - p; glm::dot(apart, apart) < radius_ * radius_)
          sum += q->volume * cubic_spline(glm::length(glm::dvec3(apart)), double{radius_});
      ratios.push_back(sum);
    }
    return ratios;
  }

  double volume() const { return volume_; }  ///< m/ρ₀ of a particle, m³
  /// The boundary particles, where the last frame has them.
  const sim::Boundary& boundary() const { return walls_.boundary(); }

 private:
  struct Point {
    glm::vec3 position;  ///< m
    double volume = 0;   ///< m³
  };

  sim::Settings settings_;
  float radius_;   ///< of the kernel's support, m
  double volume_;  ///< m³
  sim::Walls walls_;
  sim::Executor executor_;
};

}  // namespace spindrift::test
