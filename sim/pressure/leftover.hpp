// Compression that one step leaves to the next. A step ends within a tolerance, not at zero. Taken
// away by the next step's pressure, what is left over would become velocity, the more the shorter
// the step. So it is kept, and taken away over the time in which gravity moves a particle by a part
// of its support; meanwhile the positions alone are eased (PressureSolver::ease), from which no
// velocity comes. For the same reason short steps may add only a part of the tolerance: an error in
// density is an error in velocity divided by the step.
#pragma once

#include "sim/core/settings.hpp"
#include "sim/particles/formulas.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class Leftover {
 public:
  Leftover(const SolverSettings& settings, float support_radius)
      : settings_(settings), support_radius_(support_radius) {}

  /// Notes the compression that there is, from density ratios and pressures: at the end of a step,
  /// or of particles as they are given.
  /// @param position of the particles, m, as long as the neighbour lists ask for
  /// @param held 1 for particles that a nozzle moves, which do not count; null: there are none
  void note(Executor& executor, Particles& particles, const PointView& position,
            const BoundaryView& boundary, const FluidConstants& constants, const float* held);

  /// Compression that a step of length dt, s, tried for the given time, may leave, per particle.
  /// @param acceleration of the body, m/s²
  const float* allow(Executor& executor, Particles& particles, double dt, int refusals,
                     float acceleration);

  /// Part of the tolerance that the step may add.
  float rate() const { return rate_; }
  /// Part of what is left over that the step may keep.
  float kept() const { return kept_; }
  /// Sum over all particles of what is above zero.
  double total() const { return total_; }

 private:
  SolverSettings settings_;
  float support_radius_;  ///< m
  float rate_ = 1, kept_ = 0;
  double total_ = 0;
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
