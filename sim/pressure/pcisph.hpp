// Predictive-corrective incompressible SPH: Solenthaler & Pajarola 2009, Algorithm 1.
#pragma once

#include <memory>

#include "sim/core/settings.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// @param settings tolerances and limits of the iteration
std::unique_ptr<PressureSolver> make_pcisph(const SolverSettings& settings,
                                            const FluidConstants& constants);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
