// The numbers of conjugate gradients that hold from one iteration to the next: they stay where the
// loops are, which look at them.
#pragma once

#include "sim/geometry/host_device.hpp"

namespace spindrift::sim {

struct ConjugateGradients {
  double squared = 0;    ///< of the residual
  double goal = 0;       ///< of that
  float beta = 0;        ///< part of the last direction in the next
  float step = 0;        ///< along the direction
  bool goes_on = false;  ///< the goal is not reached yet

  /// Those at the start. @param tolerance part of what the residual's square is that may be left
  SPINDRIFT_HD static ConjugateGradients to(double tolerance, double squared) {
    const double goal = tolerance * squared;
    return {squared, goal, 0, 0, squared > goal};
  }
  /// @param curvature of the direction
  SPINDRIFT_HD void find_step(double curvature) {
    goes_on = goes_on && curvature > 0;
    step = goes_on ? static_cast<float>(squared / curvature) : 0.f;
  }
  /// @param next the residual's square after the step
  SPINDRIFT_HD void find_beta(double next) {
    if (!goes_on)
      return;
    beta = static_cast<float>(next / squared);
    squared = next;
    goes_on = squared > goal;
  }
};

}  // namespace spindrift::sim
