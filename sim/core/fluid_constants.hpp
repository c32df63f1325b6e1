// The numbers of a liquid.
#pragma once

namespace spindrift::sim {

/// What stays the same during a run.
struct FluidConstants {
  float spacing;          ///< m
  float support_radius;   ///< H = 2 spacings, m
  float rest_density;     ///< ρ₀, kg/m³
  float volume;           ///< V = m/ρ₀: a full lattice has exactly the rest density, m³
  float viscosity;        ///< dynamic viscosity μ, Pa·s
  float wall_viscosity;   ///< μ_w, with which walls hold the liquid back, Pa·s
  float surface_tension;  ///< σ, N/m
  float contact_angle;    ///< θ, of the liquid on walls, degrees
};

}  // namespace spindrift::sim
