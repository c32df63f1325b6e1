// The equations of motion, one per-particle formula per function, written once for all backends.
//
// Density is a ratio to the rest density, with boundary particles b of volume V_b (Akinci et al.
// 2012):
//   ρᵢ/ρ₀ = V Σⱼ W(xᵢ − xⱼ) + Σ_b V_b W(xᵢ − x_b),   V = m/ρ₀.
// A boundary particle has a density and a pressure of its own (Band et al. 2018, "Pressure
// boundaries for implicit incompressible SPH"); solid_b is what the solid behind it would
// contribute:
//   ρ_b/ρ₀ = solid_b + V Σⱼ W(x_b − xⱼ).
// Pressure acceleration is the gradient of the sum of V p ρ/ρ₀ over fluid and boundary particles,
// so that momentum is kept between particles and no energy is made at walls, whatever the pressures
// are:
//   aᵢ = −1/ρ₀ [ V Σⱼ (pᵢ + pⱼ) ∇W + Σ_b V_b (pᵢ + p_b) ∇W ].
// Solenthaler & Pajarola 2009 have pᵢ/ρᵢ² + pⱼ/ρⱼ². With ρ₀ in place of ρᵢ, as in their derivation
// of δ (their eq. 6), p is a plain multiplier of the constraint ρᵢ ≤ ρ₀, and no density pass is
// needed first.
#pragma once

#include <cstdint>

#include "sim/backend/backend.hpp"
#include "sim/core/diffusion.hpp"
#include "sim/core/fluid_constants.hpp"
#include "sim/core/kernels.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// The boundary particles of walls and obstacles, as loops see them, with the neighbour lists
/// between them and the fluid particles. Arrays have one value per boundary particle.
struct BoundaryView {
  PointView position;                     ///< position, m, with the volume V_b, m³
  const float* solid = nullptr;           ///< part of the density ratio that the solid makes up for
  const float* wall_viscosity = nullptr;  ///< μ_b, Pa·s; null: all have the fluid's μ_w
  Vec3Arrays velocity;                    ///< velocity, m/s; null: all are at rest
  float* pressure = nullptr;              ///< pressure of the last step, Pa
  float* step_pressure = nullptr;         ///< the iterate of this step's pressure, Pa
  float* compression = nullptr;           ///< ρ_b/ρ₀ − 1 left over by the last step
  float* mean_pressure = nullptr;      ///< sum of pressure times time since the last frame, Pa·s
  NeighbourView neighbours;            ///< the boundary particles near each fluid particle
  NeighbourView fluid;                 ///< the fluid particles near each boundary particle
  const std::uint32_t* wet = nullptr;  ///< indices of the boundary particles with fluid neighbours
  std::uint32_t wet_count = 0;         ///< length of `wet`
  std::uint32_t count = 0;             ///< number of all boundary particles
};

/// The density ratio ρᵢ/ρ₀ of fluid particle i, with the fluid particles at `position`.
SPINDRIFT_HD inline float density_ratio(std::uint32_t i, const FluidConstants& c,
                                        const CubicKernel& kernel, const PointView& position,
                                        const NeighbourView& neighbours,
                                        const BoundaryView& boundary) {
  const Vec3<float> xi = position[i];
  const float fluid = neighbours.sum(i, [&](auto j) {
    const auto d = xi - position[j];
    return kernel.value(square_root(dot(d, d)));
  });
  const float solid = boundary.neighbours.sum(i, [&](auto b) {
    const auto [xb, volume] = boundary.position.point(b);
    const auto d = xi - xb;
    return volume * kernel.value(square_root(dot(d, d)));
  });
  return c.volume * fluid + solid;
}

/// The part of ρᵢ/ρ₀ that comes from boundary particles, and from particles in a nozzle, for which
/// held[j] is 1.
SPINDRIFT_HD inline float carried_density_ratio(std::uint32_t i, const FluidConstants& c,
                                                const CubicKernel& kernel,
                                                const PointView& position, const float* held,
                                                const NeighbourView& neighbours,
                                                const BoundaryView& boundary) {
  const Vec3<float> xi = position[i];
  const float fluid = neighbours.sum(i, [&](auto j) {
    const auto d = xi - position[j];
    return load(held, j) * kernel.value(square_root(dot(d, d)));
  });
  const float solid = boundary.neighbours.sum(i, [&](auto b) {
    const auto [xb, volume] = boundary.position.point(b);
    const auto d = xi - xb;
    return volume * kernel.value(square_root(dot(d, d)));
  });
  return c.volume * fluid + solid;
}

/// The density ratio ρ_b/ρ₀ of boundary particle b, with the fluid particles at `position`.
SPINDRIFT_HD inline float boundary_density_ratio(std::uint32_t b, const FluidConstants& c,
                                                 const CubicKernel& kernel,
                                                 const PointView& position,
                                                 const BoundaryView& boundary) {
  const Vec3<float> xb = boundary.position[b];
  const float fluid = boundary.fluid.sum(b, [&](auto j) {
    const auto d = xb - position[j];
    return kernel.value(square_root(dot(d, d)));
  });
  return boundary.solid[b] + c.volume * fluid;
}

/// Acceleration of fluid particle i by pressure, m/s².
/// @param at the fluid particles' positions, m, with their pressures, Pa
template <class Kernel>
SPINDRIFT_HD Vec3<float> pressure_acceleration(std::uint32_t i, const FluidConstants& c,
                                               const Kernel& kernel, const PointView& at,
                                               const NeighbourView& neighbours,
                                               const BoundaryView& boundary) {
  const auto [xi, pi] = at.point(i);
  const Vec3<float> fluid = neighbours.sum(i, [&, xi = xi, pi = pi](auto j) {
    const auto [xj, pj] = at.point(j);
    const auto d = xi - xj;
    return ((pi + pj) * kernel.gradient(square_root(dot(d, d)))) * d;
  });
  const Vec3<float> solid = boundary.neighbours.sum(i, [&, xi = xi, pi = pi](auto b) {
    const auto [xb, volume] = boundary.position.point(b);
    const auto d = xi - xb;
    const auto p = pi + load(boundary.step_pressure, b);
    return (volume * p * kernel.gradient(square_root(dot(d, d)))) * d;
  });
  return (-1.f / c.rest_density) * (c.volume * fluid + solid);
}

/// Pressure of fluid particle i in the sense of mechanics, Pa: a third of the trace of the virial
/// stress (Irving & Kirkwood 1950) of the forces behind pressure_acceleration(), with half of each
/// pair's stress given to particle i:
///   Pᵢ = −1/6 [ V Σⱼ (pᵢ + pⱼ) r⃗·∇W + Σ_b V_b (pᵢ + p_b) r⃗·∇W ],   r⃗ = xᵢ − xⱼ.
/// For one p everywhere it is p times −V/3 Σⱼ r⃗·∇W, a factor that is 1 for a kernel wide against
/// the spacing d. At H = 2d the factor depends on how the particles lie: with the cubic kernel it
/// is 1.02 on a cubic lattice and 0.97 on a face-centred one, with the spiky kernel 0.94 of that.
/// It is linear in the pressures, so that it may be given their sums over time, Pa·s, and gives
/// such a sum.
/// @param at the fluid particles' positions, m, with their pressures; those of the boundary
///           particles are taken from BoundaryView::mean_pressure
template <class Kernel>
SPINDRIFT_HD float mechanical_pressure(std::uint32_t i, const FluidConstants& c,
                                       const Kernel& kernel, const PointView& at,
                                       const NeighbourView& neighbours,
                                       const BoundaryView& boundary) {
  const auto [xi, pi] = at.point(i);
  const float fluid = neighbours.sum(i, [&, xi = xi, pi = pi](auto j) {
    const auto [xj, pj] = at.point(j);
    const auto d = xi - xj;
    const auto r2 = dot(d, d);
    return (pi + pj) * kernel.gradient(square_root(r2)) * r2;
  });
  const float solid = boundary.neighbours.sum(i, [&, xi = xi, pi = pi](auto b) {
    const auto [xb, volume] = boundary.position.point(b);
    const auto d = xi - xb;
    const auto r2 = dot(d, d);
    const auto p = pi + load(boundary.mean_pressure, b);
    return volume * p * kernel.gradient(square_root(r2)) * r2;
  });
  return -1.f / 6.f * (c.volume * fluid + solid);
}

/// Acceleration of fluid particle i by viscosity, μ/ρ₀ ∇²v, m/s², with weights w of the Laplacian:
///   aᵢ = 1/ρ₀ [ μ Σⱼ w (vⱼ − vᵢ) + 2 Σ_b μ_b (V_b/V) w (v_b − vᵢ) ].
/// The factor 2 makes the wall's surface, not the boundary particle, have the velocity v_b: a
/// boundary particle lies as far behind the surface as the liquid's first particles are in front of
/// it, and mirrors their velocity relative to the wall. The form that acts only along the line
/// between two particles (Monaghan 2005) keeps angular momentum as well, but on a lattice, which
/// laminar flow stays close to, shear along the axes would meet 0.7 of the viscosity.
SPINDRIFT_HD inline Vec3<float> viscous_acceleration(std::uint32_t i, const FluidConstants& c,
                                                     const DiffusionKernel& kernel,
                                                     const PointView& position,
                                                     const PointView& velocity,
                                                     const NeighbourView& neighbours,
                                                     const BoundaryView& boundary) {
  const Vec3<float> xi = position[i], vi = velocity[i];
  Vec3<float> sum{0, 0, 0};
  if (c.viscosity > 0)
    sum = c.viscosity * neighbours.sum(i, [&](auto j) {
      const auto d = xi - position[j];
      return kernel.weight(dot(d, d)) * (velocity[j] - vi);
    });
  if (boundary.wall_viscosity != nullptr) {
    const bool moving = boundary.velocity.x != nullptr;
    sum += (2 / c.volume) * boundary.neighbours.sum(i, [&](auto b) {
      const auto [xb, volume] = boundary.position.point(b);
      const auto d = xi - xb;
      const auto weight = load(boundary.wall_viscosity, b) * volume * kernel.weight(dot(d, d));
      const auto relative = moving ? boundary.velocity[b] - vi : (0.f * weight) * vi - vi;
      return weight * relative;
    });
  } else if (c.wall_viscosity > 0) {
    const float near = boundary.neighbours.sum(i, [&](auto b) {
      const auto [xb, volume] = boundary.position.point(b);
      const auto d = xi - xb;
      return volume * kernel.weight(dot(d, d));
    });
    sum += (-2 * c.wall_viscosity * near / c.volume) * vi;
  }
  return (1 / c.rest_density) * sum;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
