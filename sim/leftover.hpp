// Compression that one step leaves to the next. A step ends within a tolerance, not at zero. What
// is left over of single particles the next step takes away. What is left over of many particles
// together would, taken away within one step, throw the liquid above them up, the faster the
// shorter the step; it is taken away over the time in which gravity moves a particle by a part of
// its support. So is, step by step, that of a particle that is far too dense. For the same reason
// short steps may add only a part of the tolerance: an error in density is an error in velocity
// divided by the step.
#pragma once

#include "sim/backend.hpp"
#include "sim/particles.hpp"
#include "sim/settings.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class Leftover {
 public:
  Leftover(const SolverSettings& settings, float support_radius)
      : settings_(settings), support_radius_(support_radius) {}

  /// Notes the compression that there is, from density ratios and pressures: at the end of a step,
  /// or of particles as they are given.
  /// @param held 1 for particles that a nozzle moves, which do not count; null: there are none
  void note(Executor& executor, Particles& particles, const float* held);

  /// Compression that a step of length dt, s, tried for the given time, may leave, per particle.
  /// @param acceleration of the body, m/s²
  const float* allow(Executor& executor, Particles& particles, CellGridView grid, double dt,
                     int refusals, float acceleration);

  /// Part of the tolerance that the step may add.
  float rate() const { return rate_; }

 private:
  SolverSettings settings_;
  float support_radius_;  ///< m
  float rate_ = 1;
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
