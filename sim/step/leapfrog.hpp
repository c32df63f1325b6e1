// The two ends of a time step: particles drift to where they would be without pressure, and move on
// to where pressure has put them. Velocities belong to the middle of a step (leapfrog), so that
// free fall is exact at every step length.
#pragma once

#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Sums over the particles that were moved.
struct Motion {
  float squared_speed = 0;      ///< of the fastest, m²/s²
  std::int64_t contacts = 0;    ///< particles that a surface stopped
  double squared_pressure = 0;  ///< Σ p², Pa²
  /// Σ of the velocity changes by contacts times the velocities of the walls they hit, over the
  /// time step size, m²/s³: times a particle's mass it is the power of moving walls.
  double wall_power = 0;
  SPINDRIFT_HD void join(const Motion& o) {
    squared_speed = std::max(squared_speed, o.squared_speed);
    contacts += o.contacts;
    squared_pressure += o.squared_pressure;
    wall_power += o.wall_power;
  }
};

/// Kicks the velocities and moves the particles over a time step: sets the drifted positions and
/// velocities. Surfaces stop particles. Particles of nozzles do not count in the sums.
/// @param held     as in StepView
/// @param kick     change of every velocity by gravity and body forces, m/s
/// @param duration of the step, s
Motion drift(Executor& executor, Particles& particles, const ContactView& contact,
             const float* held, const Vec3<float>& kick, float duration);

/// Takes over the corrected positions, with the velocities and pressures that belong to them, of
/// particles and boundary particles, and adds up pressure times time.
/// @param pressure_factor from the solver's iterate to the pressure that is kept
Motion integrate(const StepContext& step, float pressure_factor);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
