// Sums over a full cubic lattice of particles. They are what a kernel and a spacing give deep
// inside the liquid, and scale the formulas so that a liquid at rest has its rest density.
#pragma once

#include "sim/core/real.hpp"

namespace spindrift::sim {

/// Calls f(p) for every lattice point p, m, closer to the origin than the radius, m, the origin
/// included, in a fixed order.
template <class F>
void for_lattice_points(float spacing, float radius, F f) {
  const int n = static_cast<int>(radius / spacing) + 1;
  for (int k = -n; k <= n; ++k)
    for (int j = -n; j <= n; ++j)
      for (int i = -n; i <= n; ++i) {
        const Vec3<float> p{static_cast<float>(i) * spacing, static_cast<float>(j) * spacing,
                            static_cast<float>(k) * spacing};
        if (dot(p, p) < radius * radius)
          f(p);
      }
}

/// Σ W over a full lattice, 1/m³. Its inverse is the particle volume that gives the lattice the
/// rest density.
template <class Kernel>
double lattice_kernel_sum(const Kernel& kernel, float spacing, float radius) {
  double sum = 0;
  for_lattice_points(spacing, radius,
                     [&](const Vec3<float>& p) { sum += kernel.value(square_root(dot(p, p))); });
  return sum;
}

/// Σ ∇W·∇W over a full lattice, 1/m⁸, with one gradient of the density's kernel and one of the
/// pressure's.
template <class DensityKernel, class PressureKernel>
double lattice_gradient_product(const DensityKernel& density, const PressureKernel& pressure,
                                float spacing, float radius) {
  double sum = 0;
  for_lattice_points(spacing, radius, [&](const Vec3<float>& p) {
    const float r = square_root(dot(p, p));
    if (r > 0)
      sum += double{density.gradient(r)} * pressure.gradient(r) * dot(p, p);
  });
  return sum;
}

}  // namespace spindrift::sim
