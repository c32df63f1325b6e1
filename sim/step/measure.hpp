// Measures the compression, the energies and the pressure of the liquid as it stands, independently
// of any solver.
#pragma once

#include "sim/boundary/neighbourhood.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// What measure() finds.
struct Measured {
  double mean_compression = 0;  ///< mean of max(0, ρ/ρ₀ − 1) over the particles
  double max_compression = 0;   ///< largest ρ/ρ₀ − 1, at least 0
  double kinetic_energy = 0;    ///< J
  double potential_energy = 0;  ///< relative to the domain's lowest corner along gravity, J
  double rms_pressure = 0;      ///< root mean square over the particles, Pa
};

/// Sum of the kinetic and potential energy of one particle, J; the potential energy is relative to
/// the domain's lowest corner along gravity.
/// @param position of the particle, m
/// @param velocity of the particle, m/s
double energy_of(const FluidConstants& constants, const Settings& settings,
                 const glm::vec3& position, const glm::vec3& velocity);

/// Recomputes every particle's density ratio from its position with the full neighbourhood, and
/// sums up. It makes the drifted positions equal to the positions, and sorts and lists the
/// particles anew.
/// @param radius within which neighbours are listed, m
Measured measure(Executor& executor, Particles& particles, Neighbourhood& neighbourhood,
                 const FluidConstants& constants, const Settings& settings, float radius);

/// Turns the sums of pressure times time in Particles::mean_pressure, Pa·s, into mechanical
/// pressures, Pa, with the neighbours of the step that ends here. It overwrites the density ratios.
/// @param kernel whose gradient gives the pressure force
/// @param time   over which the sums go, s
void measure_pressure(const StepContext& step, PressureKernel kernel, double time);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
