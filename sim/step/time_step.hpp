// How long the next step may be: the CFL number, forces, viscosity, and the frame's time ahead.
#pragma once

#include "sim/core/fluid_constants.hpp"
#include "sim/core/real.hpp"
#include "sim/core/settings.hpp"

namespace spindrift::sim {

class TimeStepControl {
 public:
  TimeStepControl(const SolverSettings& settings, const FluidConstants& constants,
                  float solver_limit);

  /// Length of the next step, s: the largest that every limit allows, shortened so that a whole
  /// number of equal steps lands exactly on the end of `remaining`.
  /// @param remaining    time until the next frame, s
  /// @param max_speed    fastest particle, m/s
  /// @param acceleration largest body acceleration, m/s²
  /// @param pressure     root mean square of the pressure, Pa
  double next(double remaining, double max_speed, double acceleration, double pressure);

  /// A step was accepted, or refused; after a refusal steps grow back gradually. Those that are
  /// shortened to end at a given time do not hold back the ones after them.
  void accepted(double time_step);
  double refused(double time_step);

  double last() const { return last_; }        ///< s
  double allowed() const { return allowed_; }  ///< what the last step could have been, s
  /// Goes on after a step. @param allowed what it could have been, s
  void resume(double last, double allowed);

 private:
  SolverSettings settings_;
  double support_radius_;
  double rest_density_;
  double fixed_limit_;  ///< smallest of the limits that never change, s
  double last_ = 0;     ///< s
  double allowed_ = 0;  ///< what the last step could have been had it not to end at a frame, s
};

/// Body acceleration at a time, m/s²: gravity and the keyframed part.
Vec3<float> body_acceleration(const ForceSettings& forces, double time);

}  // namespace spindrift::sim
