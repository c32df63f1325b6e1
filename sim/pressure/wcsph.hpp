// The basic SPH solver (WCSPH), which finds pressure from an equation of state in one pass, without
// iteration.
#pragma once

#include <memory>

#include "sim/core/settings.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Makes the solver, with the pressure kernel of the settings.
/// @param speed_of_sound c of the equation of state, m/s: the compression is about (v/c)² at speed
/// v
std::unique_ptr<PressureSolver> make_wcsph(const SolverSettings& settings,
                                           const FluidConstants& constants, float speed_of_sound);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
