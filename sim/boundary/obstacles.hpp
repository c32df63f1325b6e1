// A view of all obstacles, fixed and moving, for loops over particles: it keeps particles outside
// them.
#pragma once

#include <cstdint>
#include <span>

#include "sim/boundary/posed_body.hpp"
#include "sim/geometry/solid.hpp"

namespace spindrift::sim {

/// All obstacles, as plain data that loops can capture.
struct ObstacleView {
  const Solid* solids = nullptr;  ///< the fixed obstacles
  std::uint32_t count = 0;
  const PosedBody* bodies = nullptr;  ///< the moving obstacles
  std::uint32_t body_count = 0;
  float margin = 0;  ///< how near to a solid's surface particles may come, m

  ObstacleView() = default;
  /// @param spacing of the particles, m
  ObstacleView(const Solid* fixed, std::uint32_t fixed_count,
               std::span<const PosedBody> moving = {}, float spacing = 0)
      : solids(fixed),
        count(fixed_count),
        bodies(moving.data()),
        body_count(static_cast<std::uint32_t>(moving.size())),
        margin(1e-3f * spacing) {}

  SPINDRIFT_HD bool any() const { return count > 0 || body_count > 0; }
  SPINDRIFT_HD bool any_moves() const { return body_count > 0; }

  /// The point itself, or, if it is in an obstacle, a point near it that has been pushed out of
  /// each in turn, m.
  SPINDRIFT_HD Vec3<float> hold(Vec3<float> p) const {
    p = hold_off_bodies(p);
    for (std::uint32_t k = 0; k < count; ++k)
      p = push_out_of(solids[k], p);
    return p;
  }
  /// Does the same for the moving obstacles alone.
  SPINDRIFT_HD Vec3<float> hold_off_bodies(Vec3<float> p) const {
    for (std::uint32_t k = 0; k < body_count; ++k)
      p = bodies[k].hold(p);
    return p;
  }

  /// Where a particle ends that moves from `from` to `p` and may not pass a moving obstacle, m.
  /// @param since where the moving obstacles are when the particle is at `from`
  SPINDRIFT_HD Vec3<float> keep_out_of_bodies(const Vec3<float>& from, Vec3<float> p,
                                              Since since) const {
    for (std::uint32_t k = 0; k < body_count; ++k)
      p = bodies[k].keep_out(from, p, since, margin);
    return p;
  }
  /// Does the same for every obstacle.
  SPINDRIFT_HD Vec3<float> keep_out(const Vec3<float>& from, Vec3<float> p, Since since) const {
    p = keep_out_of_bodies(from, p, since);
    for (std::uint32_t k = 0; k < count; ++k) {
      const glm::vec3 begin = to_glm(from), end = to_glm(p);
      if (solids[k].may_meet(begin, end, margin))
        p = from_glm(solids[k].end_outside(begin, end, margin));
    }
    return p;
  }

  /// Whether a path is certainly clear of all obstacles; false says nothing, and is the answer
  /// whenever any obstacle moves.
  SPINDRIFT_HD bool is_clear(const Vec3<float>& from, const Vec3<float>& to) const {
    if (body_count > 0)
      return false;
    const glm::vec3 begin = to_glm(from), end = to_glm(to);
    for (std::uint32_t k = 0; k < count; ++k)
      if (solids[k].may_meet(begin, end, margin) &&
          !solids[k].is_surely_clear(end, glm::distance(begin, end) + margin))
        return false;
    return true;
  }

  /// The velocity of the moving obstacle that has pushed a particle to `p`, m/s; 0 if none has.
  /// @param push the displacement by which the particle was pushed, m
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
