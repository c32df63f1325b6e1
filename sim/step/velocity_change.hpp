// The last part of every force that acts before pressure.
#pragma once

#include <cmath>

#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Adds the velocity changes that a force has left, m/s, to the drifted velocities, and
/// moves the drifted positions on by them. What a nozzle moves is left alone.
/// @return whether particles moved so far that they must be listed anew
inline bool change_velocities(const StepContext& s, std::string_view name) {
  // Lists reach this far beyond the support radius, and pressure needs the most of it.
  constexpr float largest_move = 0.01f;
  Particles& p = s.particles;
  const PointView x = p.drifted_position.view(), v = p.drifted_velocity.view();
  const Vec3Arrays dv = p.velocity_change().view();
  const float dt = s.time_step;
  const StepView step = s.view();
  const auto change_one = [=] SPINDRIFT_HD(std::uint32_t i) {
    if (step.is_held(i))
      return Largest{};
    const Vec3<float> change = dv[i], move = dt * change;
    v.set(i, v[i] + change);
    x.set(i, step.contact.resolve(x[i], x[i] + move));
    return Largest{dot(move, move)};
  };
  const auto squared_move = s.executor.reduce<Largest>(name, p.count, change_one);
  return std::sqrt(squared_move.value) > largest_move * s.constants.support_radius;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
