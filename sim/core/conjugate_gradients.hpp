// The scalars of a conjugate gradient solve. A backend keeps them where its loops run (Kept in
// executor.hpp), so that the host need not wait for them in every iteration.
#pragma once

#include "sim/geometry/host_device.hpp"

namespace spindrift::sim {

/// What holds from one iteration of a conjugate gradient solve of A x = b to the next.
struct ConjugateGradients {
  double squared = 0;    ///< squared norm of the residual
  double goal = 0;       ///< squared norm at which the solve ends
  float beta = 0;        ///< share of the last search direction in the next one
  float step = 0;        ///< step length along the search direction
  bool goes_on = false;  ///< whether the goal is still to be reached

  /// The state at the start of a solve.
  /// @param tolerance share of the residual's squared norm that may be left at the end
  /// @param squared   squared norm of the first residual
  SPINDRIFT_HD static ConjugateGradients to(double tolerance, double squared) {
    const double goal = tolerance * squared;
    return {squared, goal, 0, 0, squared > goal};
  }
  /// Finds the step length; the solve ends if the curvature is not positive.
  /// @param curvature dᵀA d of the search direction d
  SPINDRIFT_HD void find_step(double curvature) {
    goes_on = goes_on && curvature > 0;
    step = goes_on ? static_cast<float>(squared / curvature) : 0.f;
  }
  /// Finds the share of the last direction in the next one, and whether the solve goes on.
  /// @param next squared norm of the residual after the step
  SPINDRIFT_HD void find_beta(double next) {
    if (!goes_on)
      return;
    beta = static_cast<float>(next / squared);
    squared = next;
    goes_on = squared > goal;
  }
};

}  // namespace spindrift::sim
