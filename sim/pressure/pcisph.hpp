// Predictive-corrective incompressible SPH: Solenthaler & Pajarola 2009, Algorithm 1.
#pragma once

#include <memory>

#include "sim/core/settings.hpp"
#include "sim/pressure/leftover.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// The PCISPH pressure solver. settle() calls it with an allowance of its own.
class PcisphSolver : public PressureSolver {
 public:
  using PressureSolver::solve;
  /// Solves a step as PressureSolver::solve() does, with the given compression left as it is.
  virtual StepResult solve(const StepContext& step, const Allowance& allowance) = 0;
};

/// Makes the solver, with the pressure kernel of the settings.
/// @param settings tolerances and limits of the iteration
std::unique_ptr<PcisphSolver> make_pcisph(const SolverSettings& settings,
                                          const FluidConstants& constants);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
