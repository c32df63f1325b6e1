// Kernel weights of the Laplacian of a field that particles carry. Viscosity and the coarse grid of
// the pressure solver use them.
#pragma once

#include "sim/core/lattice.hpp"

namespace spindrift::sim {

/// Weights w(r), 1/m², with Σⱼ w x² = 2 over a full lattice, so that Σⱼ w(|xᵢ − xⱼ|) (fⱼ − fᵢ) is
/// ∇²f (Brookshaw 1985 has this form). `Shape` gives w(r) up to its scale, from r²/H².
template <class Shape>
struct LaplacianWeights {
  float inverse_squared_radius;  ///< 1/H², 1/m²
  float scale = 1;               ///< factor of Shape::value(), 1/m²

  LaplacianWeights(float spacing, float support_radius)
      : inverse_squared_radius(1 / (support_radius * support_radius)) {
    double squared_x = 0;
    for_lattice_points(spacing, support_radius, [&](const Vec3<float>& p) {
      squared_x += double{weight(dot(p, p))} * p.x * p.x;
    });
    scale = static_cast<float>(2 / squared_x);
  }

  /// The weight w, 1/m², at a squared distance, m²; zero from the support radius on.
  template <class Real>
  SPINDRIFT_HD Real weight(Real squared_distance) const {
    const Real q2 = squared_distance * inverse_squared_radius;
    const Real zero = q2 * 0.f;
    return q2 < 1.f ? scale * Shape::value(q2) : zero;
  }
};

/// The shape 1 − r/H: the Laplacian of the viscosity kernel of Müller et al. (2003, eq. 22), whose
/// continuous scale is 1.2 % less. Its steep start calms neighbours that jitter against each other.
struct SteepShape {
  template <class Real>
  SPINDRIFT_HD static Real value(Real q2) {
    return 1.f - square_root(q2);
  }
};

/// The shape (1 − r²/H²)², whose sums change little when rows of particles slide past each other.
struct SmoothShape {
  template <class Real>
  SPINDRIFT_HD static Real value(Real q2) {
    return (1.f - q2) * (1.f - q2);
  }
};

using DiffusionKernel = LaplacianWeights<SteepShape>;     ///< weights of viscosity
using ConductanceKernel = LaplacianWeights<SmoothShape>;  ///< weights of the coarse grid

}  // namespace spindrift::sim
