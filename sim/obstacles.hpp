// Obstacles as loops look at them: of every shape, fixed and moving.
#pragma once

#include <cstdint>
#include <span>

#include "sim/posed_body.hpp"
#include "sim/solid.hpp"

namespace spindrift::sim {

struct ObstacleView {
  const Solid* solids = nullptr;  ///< those that are fixed
  std::uint32_t count = 0;
  const PosedBody* bodies = nullptr;  ///< those that move
  std::uint32_t body_count = 0;

  ObstacleView() = default;
  ObstacleView(const Solid* fixed, std::uint32_t fixed_count,
               std::span<const PosedBody> moving = {})
      : solids(fixed),
        count(fixed_count),
        bodies(moving.data()),
        body_count(static_cast<std::uint32_t>(moving.size())) {}

  /// The point itself, or one outside every obstacle, near it.
  SPINDRIFT_HD Vec3<float> hold(Vec3<float> p) const {
    for (std::uint32_t k = 0; k < body_count; ++k)
      p = bodies[k].hold(p);
    for (std::uint32_t k = 0; k < count; ++k)
      p = push_out(solids[k], p);
    return p;
  }

  /// How far from `from` towards a point a particle gets that does not pass what moves.
  SPINDRIFT_HD Vec3<float> sweep(const Vec3<float>& from, Vec3<float> p) const {
    for (std::uint32_t k = 0; k < body_count; ++k)
      p = bodies[k].sweep(from, p);
    return p;
  }

  SPINDRIFT_HD bool any_moves() const { return body_count > 0; }

  /// Velocity of the moving body that pushed a particle to where it is, m/s; 0 if none did.
  SPINDRIFT_HD Vec3<float> velocity_behind(const Vec3<float>& p, const Vec3<float>& push) const {
    const float length = square_root(dot(push, push));
    for (std::uint32_t k = 0; k < body_count; ++k) {
      const Vec3<float> behind = p - (0.01f * bodies[k].spacing / length) * push;
      if (bodies[k].holds(behind))
        return bodies[k].velocity(bodies[k].pose.back(behind));
    }
    return {0, 0, 0};
  }
};

}  // namespace spindrift::sim
