// Applies the velocity changes of a force that acts before pressure; every Force ends with it.
#pragma once

#include <cmath>

#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Adds the velocity changes that a force has left in Particles::velocity_change(), m/s, to the
/// drifted velocities, and moves the drifted positions on by them, with contact. Particles in a
/// nozzle are left alone.
/// @param name the phase in the profile, a string literal
/// @return whether any particle moved so far that neighbours must be listed anew
inline bool change_velocities(const StepContext& s, std::string_view name) {
  // In support radii. Neighbour lists reach a little beyond the support radius, and pressure needs
  // most of that.
  constexpr float largest_move = 0.01f;
  Particles& p = s.particles;
  const PointView x = p.drifted_position.view(), v = p.drifted_velocity.view();
  const Vec3Arrays dv = p.velocity_change().view();
  const float dt = s.time_step();
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
