// Chooses the time step size, from the CFL number, the accelerations, the pressure, the limits of
// the solver and the forces, and the time left to the next frame.
#pragma once

#include "sim/core/fluid_constants.hpp"
#include "sim/core/real.hpp"
#include "sim/core/settings.hpp"

namespace spindrift::sim {

class TimeStepControl {
 public:
  /// @param solver_limit smallest time step size limit of the solver and the forces, s
  TimeStepControl(const SolverSettings& settings, const FluidConstants& constants,
                  float solver_limit);

  /// Size of the next step, s: the largest that every limit allows, shortened so that a whole
  /// number of equal steps lands exactly on the end of `remaining`.
  /// @param remaining    time until the next frame or other event, s
  /// @param max_speed    largest speed of any particle, wall or nozzle, m/s
  /// @param acceleration magnitude of the body acceleration, m/s²
  /// @param pressure     root mean square of the particles' pressure, Pa
  double next(double remaining, double max_speed, double acceleration, double pressure);

  /// Notes that a step of this size, s, was accepted. A step that was shortened to end at a given
  /// time does not hold back the ones after it.
  void accepted(double time_step);
  /// Notes that a step of this size, s, was refused; steps after it grow back gradually.
  /// @return the size to repeat the step with, s
  /// @throws std::runtime_error when that is below the smallest size that the settings allow
  double refused(double time_step);

  /// Size of the last accepted step, s.
  double last() const { return last_; }
  /// Size that the limits allowed for the last step, s.
  double allowed() const { return allowed_; }
  /// Goes on after a step of an earlier run.
  /// @param last    size of that step, s
  /// @param allowed size that the limits allowed for it, s
  void resume(double last, double allowed);

 private:
  SolverSettings settings_;
  double support_radius_;
  double rest_density_;
  double fixed_limit_;  ///< smallest of the limits that never change, s
  double last_ = 0;     ///< size of the last accepted step, s
  double allowed_ = 0;  ///< size of the last step without having to end at a frame, s
};

/// Body acceleration at a time, s, in m/s²: gravity and the keyframed part.
Vec3<float> body_acceleration(const ForceSettings& forces, double time);

}  // namespace spindrift::sim
