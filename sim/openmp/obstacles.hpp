// Obstacles as loops on the processor see them: of every shape, fixed and moving.
#pragma once

#include <cstdint>
#include <span>

#include "sim/posed_body.hpp"
#include "sim/solid.hpp"

namespace spindrift::sim::inline openmp {

struct ObstacleView {
  const Solid* solids = nullptr;  ///< those that are fixed
  std::uint32_t count = 0;
  std::span<const PosedBody> bodies = {};  ///< those that move

  /// The point itself, or one outside every obstacle, near it.
  Vec3<float> hold(Vec3<float> p) const {
    for (const PosedBody& body : bodies)
      p = body.hold(p);
    for (std::uint32_t k = 0; k < count; ++k)
      p = push_out(solids[k], p);
    return p;
  }

  /// How far from `from` towards a point a particle gets that does not pass what moves.
  Vec3<float> sweep(const Vec3<float>& from, Vec3<float> p) const {
    for (const PosedBody& body : bodies)
      p = body.sweep(from, p);
    return p;
  }

  bool any_moves() const { return !bodies.empty(); }

  /// Velocity of the moving body that pushed a particle to where it is, m/s; 0 if none did.
  Vec3<float> velocity_behind(const Vec3<float>& p, const Vec3<float>& push) const {
    const float length = square_root(dot(push, push));
    for (const PosedBody& body : bodies) {
      const Vec3<float> behind = p - (0.01f * body.spacing / length) * push;
      if (body.holds(behind))
        return body.velocity(body.pose.back(behind));
    }
    return {0, 0, 0};
  }
};

}  // namespace spindrift::sim::inline openmp
