// The Laplacian of a field that particles carry.
#pragma once

#include "sim/lattice.hpp"

namespace spindrift::sim {

/// Weights w(r) = k (1 − r²/H²)², 1/m², with Σⱼ w x² = 2 over a full lattice, so that
/// Σⱼ w(|xᵢ − xⱼ|) (fⱼ − fᵢ) is ∇²f (Brookshaw 1985 has this form). They change little when rows of
/// particles slide past each other; with the weights of Müller et al. (2003) what they give varies
/// by 6 %.
struct DiffusionKernel {
  float inverse_squared_radius;  ///< 1/H², 1/m²
  float scale;                   ///< k, 1/m²

  DiffusionKernel(float spacing, float support_radius)
      : inverse_squared_radius(1 / (support_radius * support_radius)), scale(1) {
    double squared_x = 0;
    for_lattice_points(spacing, support_radius, [&](const Vec3<float>& p) {
      squared_x += double{weight(dot(p, p))} * p.x * p.x;
    });
    scale = static_cast<float>(2 / squared_x);
  }

  template <class Real>
  Real weight(Real squared_distance) const {
    const Real c = 1.f - squared_distance * inverse_squared_radius;
    const Real zero = squared_distance * 0.f;
    return c > 0.f ? scale * c * c : zero;
  }
};

}  // namespace spindrift::sim
