// A moving body during one time step: its poses at the start and the end, and collisions of
// particles with it.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "sim/core/from_glm.hpp"
#include "sim/core/real.hpp"
#include "sim/core/settings.hpp"
#include "sim/geometry/solid.hpp"

namespace spindrift::sim {

/// The point on the surface of a solid nearest to `p`, if `p` is inside; otherwise `p` itself, m.
SPINDRIFT_HD inline Vec3<float> push_out_of(const Solid& solid, const Vec3<float>& p) {
  return from_glm(solid.push_out(to_glm(p)));
}

/// The affine map x ↦ M x + t.
struct Affine {
  Vec3<float> row_x{1, 0, 0}, row_y{0, 1, 0}, row_z{0, 0, 1};  ///< rows of M
  Vec3<float> offset{0, 0, 0};                                 ///< t

  SPINDRIFT_HD Vec3<float> operator()(const Vec3<float>& p) const {
    return Vec3<float>{dot(row_x, p), dot(row_y, p), dot(row_z, p)} + offset;
  }
  /// The inverse image of p. M must be a rotation.
  SPINDRIFT_HD Vec3<float> back(const Vec3<float>& p) const {
    const Vec3<float> d = p - offset;
    return d.x * row_x + d.y * row_y + d.z * row_z;
  }
};

/// The inner faces of the domain, m; an open face is infinitely far away.
struct Inside {
  Vec3<float> min, max;

  Inside() = default;
  explicit Inside(const DomainSettings& domain);

  /// The point nearest to p that is inside and at least a distance (m) away from every face.
  SPINDRIFT_HD Vec3<float> nudged(const Vec3<float>& p, float distance) const {
    return {std::clamp(p.x, min.x + distance, max.x - distance),
            std::clamp(p.y, min.y + distance, max.y - distance),
            std::clamp(p.z, min.z + distance, max.z - distance)};
  }

  /// How far a point is beyond the face that it is farthest beyond, m; negative inside.
  SPINDRIFT_HD float beyond(const Vec3<float>& p) const {
    return std::max({min.x - p.x, min.y - p.y, min.z - p.z, p.x - max.x, p.y - max.y, p.z - max.z});
  }
};

/// Where moving bodies are when a particle's path begins: where they are at the start of the step,
/// or at its end.
enum class Since { start, end };

/// A moving body in a step, as plain data that loops can capture.
struct PosedBody {
  Solid solid;  ///< where the scene places it
  Box bounds;   ///< the bounding box of `solid`, m
  Inside domain;
  Affine start, pose;  ///< map points of `solid` to where they are at the step's start and end
  Affine velocity;     ///< maps points of `solid` to their mean velocity over the step, m/s
  float spacing = 0;   ///< of the particles, m

  /// The point itself, or, if it is in the body at the step's end, a point on the body's surface
  /// that is inside the domain, m. Where the body lies flush against a wall, or sticks out through
  /// it, the nearest point of the surface can be in the wall, and is then not the one.
  SPINDRIFT_HD Vec3<float> hold(const Vec3<float>& p) const;

  /// Where a particle ends that moves from `from` to `p`, m: it does not pass the body, however
  /// fast both are and however thin the body is. In the body's frame the particle moves along a
  /// straight path (sim/geometry/entry.hpp).
  /// @param since where the body is when the particle is at `from`
  /// @param margin how near to the surface the particle may come, m
  SPINDRIFT_HD Vec3<float> keep_out(const Vec3<float>& from, const Vec3<float>& p, Since since,
                                    float margin) const;

  /// Whether a point, or a point just off the wall if it is on a wall, is in the body at the step's
  /// end.
  SPINDRIFT_HD bool holds(const Vec3<float>& p) const {
    return !is_zero(shortest_push(domain.nudged(p, nudge * spacing)));
  }

  /// How deep below the body's surface a point is at the step's end, m; 0 outside.
  SPINDRIFT_HD float depth(const Vec3<float>& p) const;

 private:
  /// Particles this near to a wall, in spacings, count as within a body that lies flush against it.
  static constexpr float nudge = 1e-3f;

  SPINDRIFT_HD static bool is_zero(const Vec3<float>& v) {
    return v.x == 0 && v.y == 0 && v.z == 0;
  }
  SPINDRIFT_HD static bool overlap(const Vec3<float>& low, const Vec3<float>& high, const Box& box,
                                   float margin) {
    return low.x <= box.max.x + margin && low.y <= box.max.y + margin &&
           low.z <= box.max.z + margin && high.x >= box.min.x - margin &&
           high.y >= box.min.y - margin && high.z >= box.min.z - margin;
  }
  /// Moves one coordinate of a point by `lift` (m) off the wall that the body pushes it into, if it
  /// does.
  SPINDRIFT_HD static void lift_off(float push, float out, float low, float high, float lift,
                                    float& coordinate) {
    const float margin = nudge * lift;
    if (push < 0 && out < low + margin)
      coordinate = low + lift;
    if (push > 0 && out > high - margin)
      coordinate = high - lift;
  }
  /// The shortest displacement that takes a point out of the body, in the scene's frame, m; 0 if
  /// the point is outside.
  SPINDRIFT_HD Vec3<float> shortest_push(const Vec3<float>& p) const {
    const Vec3<float> q = pose.back(p);
    const Vec3<float> out = push_out_of(solid, q);
    return is_zero(out - q) ? Vec3<float>{0, 0, 0} : pose(out) - p;
  }
};

SPINDRIFT_HD SPINDRIFT_APART inline Vec3<float> PosedBody::hold(const Vec3<float>& p) const {
  const Vec3<float> inner = domain.nudged(p, nudge * spacing);
  const Vec3<float> q = pose.back(inner);
  if (!overlap(q, q, bounds, 0))
    return p;
  const Vec3<float> shortest = shortest_push(inner);
  if (is_zero(shortest))
    return p;
  // Where the way out leads into a wall, the particle takes the way of a point farther off the
  // wall.
  for (float lift = spacing; lift > 0.2f * spacing; lift *= 0.5f) {
    Vec3<float> lifted = inner, push = shortest;
    for (int walls = 0; walls <= 3 && !is_zero(push); ++walls) {
      const Vec3<float> out = lifted + push, before = lifted;
      lift_off(push.x, out.x, domain.min.x, domain.max.x, lift, lifted.x);
      lift_off(push.y, out.y, domain.min.y, domain.max.y, lift, lifted.y);
      lift_off(push.z, out.z, domain.min.z, domain.max.z, lift, lifted.z);
      if (is_zero(lifted - before))
        return walls == 0 ? out : p + push;
      push = shortest_push(lifted);
    }
  }
  return inner + shortest;
}

SPINDRIFT_HD inline Vec3<float> PosedBody::keep_out(const Vec3<float>& from, const Vec3<float>& p,
                                                    Since since, float margin) const {
  const glm::vec3 begin = to_glm((since == Since::start ? start : pose).back(from)),
                  end = to_glm(pose.back(p));
  if (!solid.may_meet(begin, end, margin))
    return p;
  const glm::vec3 kept = solid.end_outside(begin, end, margin);
  return kept == end ? p : pose(from_glm(kept));
}

SPINDRIFT_HD inline float PosedBody::depth(const Vec3<float>& p) const {
  const Vec3<float> q = pose.back(p);
  if (!overlap(q, q, bounds, 0))
    return 0;
  const Vec3<float> push = push_out_of(solid, q) - q;
  return square_root(dot(push, push));
}

/// The solids of all obstacles for loops that find meshes where `meshes` puts them, such as in a
/// device's memory.
/// @param meshes has a member `const MeshView* view_of(const MeshBody&)`
template <class Meshes>
std::vector<Solid> solids_of(const std::vector<Obstacle>& obstacles, Meshes& meshes) {
  std::vector<Solid> solids;
  for (const Obstacle& obstacle : obstacles)
    solids.push_back(solid_of(obstacle.shape, meshes));
  return solids;
}
/// The solids of all obstacles for loops on the host.
std::vector<Solid> solids_of(const std::vector<Obstacle>& obstacles);

/// The bodies of all moving obstacles, in the scene's order, over a step between two times, s.
/// @param solids one for each obstacle of the settings
std::vector<PosedBody> posed_bodies(const Settings& settings, std::span<const Solid> solids,
                                    double start, double end);
/// The bodies of all moving obstacles for loops on the host; the times are as above.
std::vector<PosedBody> posed_bodies(const Settings& settings, double start, double end);

}  // namespace spindrift::sim
