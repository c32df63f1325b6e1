// Basic SPH: pressure from an equation of state, one pass, no iteration.
#pragma once

#include <memory>

#include "sim/core/settings.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// @param speed_of_sound of the equation of state, m/s: the compression is about (v/c)²
std::unique_ptr<PressureSolver> make_wcsph(const SolverSettings& settings,
                                           const FluidConstants& constants, float speed_of_sound);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
