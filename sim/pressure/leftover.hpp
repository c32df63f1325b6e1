// Compression that one PCISPH step leaves to the next. A step ends within a tolerance, not at zero.
// Taken away by the next step's pressure, what is left over would become velocity, the more the
// shorter the step. So it is kept, and taken away over the time in which gravity moves a particle
// by a part of its support radius; meanwhile the positions alone are eased
// (PressureSolver::finish), from which no velocity comes. For the same reason short steps may add
// only a part of the tolerance: an error in density, divided by the time step size, is an error in
// velocity.
#pragma once

#include "sim/core/settings.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// The compression that a step need not take away.
struct Allowance {
  const float* excess;  ///< compression that each particle may keep in this step
  float rate = 1;       ///< share of the tolerance that a step as short as this may add
  float kept = 0;  ///< share of their leftover compression that wet boundary particles may keep
  double leftover = 0;  ///< Σ max(0, ρ/ρ₀ − 1) over the particles at the start of the step
  /// Whether the particles start far too dense: then only compression beyond `excess` counts.
  bool settling = false;
  float densest = 1;  ///< largest density ratio at the start of the step where that is far above 1
};

/// Notes the compression that steps leave over, and says how much of it the next one may leave.
class Leftover {
 public:
  explicit Leftover(const SolverSettings& settings) : settings_(settings) {}

  /// Notes the present compression, from the particles' density ratios and pressures, at the end of
  /// a step or of particles as they are given. Particles in a nozzle do not count.
  /// @param position of the particles, m, followed by the sentinel that pads neighbour lists
  void note(const StepContext& step, const PointView& position);

  /// The compression that a step may leave. Particles in a nozzle may keep all of theirs that comes
  /// from walls and from each other.
  Allowance allow(const StepContext& step);

 private:
  SolverSettings settings_;
  double total_ = 0;  ///< sum of max(0, compression) over all particles
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
