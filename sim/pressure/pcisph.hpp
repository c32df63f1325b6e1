// Predictive-corrective incompressible SPH: Solenthaler & Pajarola 2009, Algorithm 1.
#pragma once

#include <memory>

#include "sim/core/settings.hpp"
#include "sim/pressure/leftover.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class PcisphSolver : public PressureSolver {
 public:
  using PressureSolver::solve;
  /// The same with what the step need not take away.
  virtual StepResult solve(const StepContext& step, const Allowance& allowance) = 0;
};

/// @param settings tolerances and limits of the iteration
std::unique_ptr<PcisphSolver> make_pcisph(const SolverSettings& settings,
                                          const FluidConstants& constants);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
