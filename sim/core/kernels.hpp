// Smoothing kernels W(r), 1/m³, all zero from the support radius H on:
//   cubic spline: Monaghan 2005; spiky: Müller, Charypar, Gross 2003, eq. 21.
// Gradients are given as the scalar ∇W / r⃗, 1/m⁵: ∇W(r⃗) = gradient(r) r⃗, with r⃗ = xᵢ − xⱼ. They
// are negative. Every function takes one distance (float) or eight (Lanes), m, and is free of
// branches.
#pragma once

#include <numbers>

#include "sim/core/real.hpp"

namespace spindrift::sim {

struct CubicKernel {
  float inverse_radius;  ///< 1/H, 1/m
  float scale;           ///< 8/(πH³), 1/m³
  float gradient_scale;  ///< 6·8/(πH⁵), 1/m⁵

  explicit CubicKernel(float support_radius) {
    const double h = support_radius;
    inverse_radius = static_cast<float>(1 / h);
    scale = static_cast<float>(8 / (std::numbers::pi * h * h * h));
    gradient_scale = static_cast<float>(48 / (std::numbers::pi * h * h * h * h * h));
  }

  // With q = r/H and the positive parts a of 1 − q and b of 1 − 2q, both pieces of the spline are
  // W = 2a³ − b³, and its slope divided by q is 6 (b² − a²)/q, up to their scales. No comparison
  // has to choose the piece.

  template <class Real>
  SPINDRIFT_HD Real value(Real r) const {
    const Real q = r * inverse_radius;
    const Real a = positive(1.f - q), b = positive(1.f - 2.f * q);
    return scale * (2.f * (a * a * a) - b * b * b);
  }

  template <class Real>
  SPINDRIFT_HD Real gradient(Real r) const {
    const Real q = r * inverse_radius;
    const Real a = positive(1.f - q), b = positive(1.f - 2.f * q);
    // At smaller q the force is nothing beside others; the bound only makes it end at zero.
    constexpr float smallest = 1e-6f;
    return gradient_scale * ((b * b - a * a) * (1.f / at_least(q, smallest)));
  }
};

struct SpikyKernel {
  float support_radius;  ///< H, m
  float scale;           ///< 15/(πH⁶), 1/m⁶

  explicit SpikyKernel(float radius) : support_radius(radius) {
    const double h = radius;
    scale = static_cast<float>(15 / (std::numbers::pi * h * h * h * h * h * h));
  }

  template <class Real>
  SPINDRIFT_HD Real value(Real r) const {
    const Real c = support_radius - r;
    const Real zero = r * 0.f;
    return scale * (c > 0.f ? c * c * c : zero);
  }

  /// At r = 0 the gradient has no direction; it is taken as zero there.
  template <class Real>
  SPINDRIFT_HD Real gradient(Real r) const {
    const Real c = support_radius - r;
    const Real zero = r * 0.f;
    const Real slope = -3.f * scale * c * c / r;
    return c > 0.f ? (r > 0.f ? slope : zero) : zero;
  }
};

}  // namespace spindrift::sim
