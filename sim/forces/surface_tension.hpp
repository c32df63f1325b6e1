// Surface tension as the gradient of an energy, so that momentum and angular momentum are kept and
// no energy is made. With c the share of the space around a particle that is liquid, smoothed over
// the support radius (1 deep in the liquid), and d the spacing, the energy is
//   E = σ d² Σᵢ [ α max(0, 1 − cᵢ)² + β d² |∇cᵢ|² ],   cᵢ = Σⱼ w(|xᵢ − xⱼ|).
// A surface thus costs what the liquid lacks near it and what c changes across it, as in van der
// Waals's theory of capillarity (1893; Cahn & Hilliard 1958). Neither term would do alone: the
// first falls when the surface's particles crowd together, the second when they part, and with one
// alone the tension dies away or the liquid evaporates. Deep in the liquid both vanish, so that the
// pressure there is the liquid's own, 2σ/R in a drop. The force is E's exact gradient:
//   Fᵢ = 2 σ d² Σⱼ [ α (qᵢ + qⱼ) ∇w − β d² ∇∇w (∇cᵢ − ∇cⱼ) ],   q = max(0, 1 − c).
// Akinci, Akinci & Teschner (2013) have cohesion and differences of normals, as forces; their
// coefficient is no σ.
//
// Walls count as liquid to the share φ: each boundary particle adds φ V_b/V to the sums. Where φ is
// 1 the liquid has no surface at the wall, and meets it at a right angle. Since E is quadratic, a
// smaller φ leaves (1 − φ)² of the tension, and Young's equation gives −cos θ = (1 − φ)².
#pragma once

#include <cmath>

#include "sim/core/lattice.hpp"
#include "sim/forces/force.hpp"

namespace spindrift::sim {

/// The kernel w(r) = scale (1 − r²/H²)³, whose sum over a full lattice is 1. It is smooth, since
/// the forces have its second derivatives.
struct TensionKernel {
  float inverse_squared_radius;  ///< 1/H², 1/m²
  float scale = 1;               ///< w(0)

  TensionKernel(float spacing, float support_radius)
      : inverse_squared_radius(1 / (support_radius * support_radius)) {
    double sum = 0;
    for_lattice_points(spacing, support_radius,
                       [&](const Vec3<float>& p) { sum += std::pow(double{reach(dot(p, p))}, 3); });
    scale = static_cast<float>(1 / sum);
  }

  /// 1 − r²/H², and zero from the support radius H on.
  template <class Real>
  SPINDRIFT_HD Real reach(Real squared_distance) const {
    const Real t = 1.f - squared_distance * inverse_squared_radius;
    const Real zero = t * 0.f;
    return t > 0.f ? t : zero;
  }
};

/// The factors and fields that the forces are computed from, as loops see them.
struct TensionView {
  TensionKernel kernel;
  float factor;           ///< factor of the accelerations between particles, 1/s²
  float gradient_factor;  ///< factor of the gradients of c in them, d β/α, m
  float wetting;          ///< φ/V, 1/m³
  float* lack = nullptr;  ///< q = max(0, 1 − c) of each particle
  Vec3Arrays gradient;    ///< d ∇c of each particle
};

/// The colour field c of one particle and d ∇c, or a part of their sums.
template <class Real>
struct Colour {
  Real value{};           ///< c
  Vec3<Real> gradient{};  ///< d ∇c

  SPINDRIFT_HD Colour& operator+=(const Colour& o) {
    value += o.value;
    gradient += o.gradient;
    return *this;
  }
};
template <class Real>
Colour<float> reduce(const Colour<Real>& c) {
  return {reduce(c.value), reduce(c.gradient)};
}

inline namespace SPINDRIFT_BACKEND {

/// The colour field of particle i and its gradient, with the walls' share of liquid.
SPINDRIFT_HD inline Colour<float> colour(std::uint32_t i, const FluidConstants& c,
                                         const TensionView& tension, const PointView& position,
                                         const NeighbourView& neighbours,
                                         const BoundaryView& boundary) {
  const TensionKernel& kernel = tension.kernel;
  const Vec3<float> xi = position[i];
  Colour<float> sum = neighbours.sum(i, [&](auto j) {
    const auto r = xi - position[j];
    const auto t = kernel.reach(dot(r, r));
    return Colour<decltype(t * t)>{t * t * t, t * t * r};
  });
  sum += boundary.neighbours.sum(i, [&](auto b) {
    const auto [xb, volume] = boundary.position.point(b);
    const auto r = xi - xb;
    const auto t = kernel.reach(dot(r, r));
    const auto part = tension.wetting * volume * t * t;
    return Colour<decltype(t * t)>{part * t, part * r};
  });
  const float slope = -6 * kernel.scale * kernel.inverse_squared_radius * c.spacing;
  return {kernel.scale * sum.value, slope * sum.gradient};
}

/// Acceleration of particle i by surface tension, m/s². TensionView::lack and ::gradient must be up
/// to date.
SPINDRIFT_HD inline Vec3<float> tension_acceleration(std::uint32_t i, const TensionView& tension,
                                                     const PointView& position,
                                                     const NeighbourView& neighbours,
                                                     const BoundaryView& boundary) {
  const TensionKernel& kernel = tension.kernel;
  const Vec3<float> xi = position[i], gi = tension.gradient[i];
  const float qi = tension.lack[i];
  const Vec3<float> liquid = neighbours.sum(i, [&](auto j) {
    const auto r = xi - position[j], turn = tension.gradient_factor * (gi - tension.gradient[j]);
    const auto t = kernel.reach(dot(r, r));
    const auto along = 4.f * kernel.inverse_squared_radius * dot(r, turn);
    return (t * (t * (qi + load(tension.lack, j)) + along)) * r - t * t * turn;
  });
  const Vec3<float> turn = tension.gradient_factor * gi;
  const Vec3<float> walls = boundary.neighbours.sum(i, [&](auto b) {
    const auto [xb, volume] = boundary.position.point(b);
    const auto r = xi - xb;
    const auto t = kernel.reach(dot(r, r));
    const auto along =
        4.f * kernel.inverse_squared_radius * (r.x * turn.x + r.y * turn.y + r.z * turn.z);
    return (tension.wetting * volume * t) * ((t * qi + along) * r - t * turn);
  });
  return tension.factor * (liquid + walls);
}

class SurfaceTension : public Force {
 public:
  /// α and β, chosen so that σ is the tension measured in a drop's pressure and oscillation: plain
  /// numbers, the same at every spacing.
  static constexpr float lack_weight = 2.55f, gradient_weight = 1.7f;

  explicit SurfaceTension(const FluidConstants& constants);

  bool apply(const StepContext& s) override;

  /// A fraction of the period scale √(ρ₀ d³/σ) of the shortest capillary waves, s.
  float time_step_limit() const override { return time_step_limit_; }

  std::size_t memory_bytes() const override { return bytes_of(lack_, gradient_); }

 private:
  float time_step_limit_;  ///< s
  TensionView view_;
  ScalarField lack_;      ///< TensionView::lack
  VectorField gradient_;  ///< TensionView::gradient
};

/// The surface tension of a scene's liquid; null where it has none.
std::unique_ptr<Force> make_surface_tension(const Settings& settings,
                                            const FluidConstants& constants);

}  // namespace SPINDRIFT_BACKEND
}  // namespace spindrift::sim
