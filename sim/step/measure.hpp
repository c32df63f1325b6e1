// The error and the energies of the liquid as it stands, independent of any solver.
#pragma once

#include "sim/boundary/neighbourhood.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

struct Measured {
  double mean_compression = 0;  ///< mean of max(0, ρ/ρ₀ − 1) over the particles
  double max_compression = 0;   ///< largest ρ/ρ₀ − 1, at least 0
  double kinetic_energy = 0;    ///< J
  double potential_energy = 0;  ///< J, against the domain's lowest corner along gravity
  double rms_pressure = 0;      ///< root mean square over the particles, Pa
};

/// Kinetic and potential energy of one particle, J, the potential against the domain's lowest
/// corner along gravity. @param position m @param velocity m/s
double energy_of(const FluidConstants& constants, const Settings& settings,
                 const glm::vec3& position, const glm::vec3& velocity);

/// Recomputes every particle's density ratio from its position with the full neighbourhood, listed
/// anew within `radius`, m, and sums up. Leaves the positions as the drifted ones.
Measured measure(Executor& executor, Particles& particles, Neighbourhood& neighbourhood,
                 const FluidConstants& constants, const Settings& settings, float radius);

/// Turns the sums of pressure times time, Pa·s, in `mean_pressure` into mechanical pressures, Pa.
/// The neighbours are those of the step that ends here. Spoils the density ratios.
/// @param time over which the sums go, s
void measure_pressure(const StepContext& step, PressureKernel kernel, double time);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
