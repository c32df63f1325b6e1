// Compression that one step leaves to the next. A step ends within a tolerance, not at zero. Taken
// away by the next step's pressure, what is left over would become velocity, the more the shorter
// the step. So it is kept, and taken away over the time in which gravity moves a particle by a part
// of its support; meanwhile the positions alone are eased (PressureSolver::finish), from which no
// velocity comes. For the same reason short steps may add only a part of the tolerance: an error in
// density is an error in velocity divided by the step.
#pragma once

#include "sim/core/settings.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// What a step need not take away.
struct Allowance {
  const float* excess;  ///< compression that a particle may keep in this step
  float rate = 1;       ///< part of the tolerance that a step as short as this may add
  float kept = 0;       ///< part of the wet samples' leftover compression that they may keep
  double leftover = 0;  ///< Σ max(0, ρ/ρ₀ − 1) over the particles at the start of the step
  bool settling =
      false;          ///< the particles start far too dense; only what goes beyond `excess` counts
  float densest = 1;  ///< largest density ratio at the start of the step where that is far above 1
};

class Leftover {
 public:
  explicit Leftover(const SolverSettings& settings) : settings_(settings) {}

  /// Notes the compression that there is, from density ratios and pressures: at the end of a step,
  /// or of particles as they are given. Those that a nozzle moves do not count.
  /// @param position of the particles, m, as long as the neighbour lists ask for
  void note(const StepContext& step, const PointView& position);

  /// What a step may leave. Compression of particles in a nozzle that comes from walls and each
  /// other is left as it is.
  Allowance allow(const StepContext& step);

 private:
  SolverSettings settings_;
  double total_ = 0;  ///< sum over all particles of what is above zero
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
