// The constants of a liquid that the formulas and solvers use.
#pragma once

namespace spindrift::sim {

/// Properties of the liquid and its particles that stay the same during a run.
struct FluidConstants {
  float spacing;         ///< distance d of neighbouring particles at rest, m
  float support_radius;  ///< H = 2 spacings, m
  float rest_density;    ///< ρ₀, kg/m³
  float volume;  ///< particle volume V = m/ρ₀ that gives a full lattice the density ρ₀, m³
  float viscosity;        ///< dynamic viscosity μ, Pa·s
  float wall_viscosity;   ///< dynamic viscosity μ_w between the liquid and walls, Pa·s
  float surface_tension;  ///< σ, N/m
  float contact_angle;    ///< θ of the liquid on walls, degrees
};

}  // namespace spindrift::sim
