// Walls' and obstacles' surfaces as a last contact: pressure from boundary particles keeps the
// liquid off them; a lone particle has no pressure, and is stopped here, without a bounce and
// without friction.
#pragma once

#include <span>
#include <vector>

#include "sim/open_faces.hpp"
#include "sim/posed_body.hpp"
#include "sim/real.hpp"
#include "sim/settings.hpp"

namespace spindrift::sim {

struct ContactView {
  Vec3<float> min, max;                 ///< inner faces of the domain, m
  const Obstacle* obstacles = nullptr;  ///< those that are fixed
  std::size_t obstacle_count = 0;
  OpenFaces open = {};
  std::span<const PosedBody> bodies = {};  ///< the obstacles that move

  /// The point itself, or the nearest one that is inside the domain and outside every obstacle, m.
  /// Beyond an open face there are no walls.
  Vec3<float> resolve(Vec3<float> p) const;

  /// The point itself, or the nearest one that is `distance`, m, off the domain's walls and outside
  /// every obstacle.
  Vec3<float> resolve_off_walls(Vec3<float> p, float distance) const;

  /// The same for a point on its way from another: no further off a wall than that one is.
  Vec3<float> stop_off_walls(Vec3<float> p, Vec3<float> from, float distance) const;

  /// The nearest such point for a particle that comes from `from`, which moving bodies do not pass.
  Vec3<float> resolve(const Vec3<float>& from, Vec3<float> p) const;

  /// Velocity of the moving body that pushed a particle to where it is, m/s; 0 if none did.
  Vec3<float> velocity_behind(const Vec3<float>& p, const Vec3<float>& push) const;

  /// Whether a point is inside the domain, or in front of an open face, and outside every obstacle.
  bool is_open(Vec3<float> p) const;
};

/// The nearest point on the surface of a shape for a point inside it; a point outside comes back as
/// it is.
Vec3<float> push_out(const Shape& shape, Vec3<float> p);

/// Whether a point is inside a shape.
bool contains(const Shape& shape, Vec3<float> p);

inline Vec3<float> ContactView::resolve(Vec3<float> p) const {
  for (const PosedBody& body : bodies)
    p = body.hold(p);
  for (std::size_t k = 0; k < obstacle_count; ++k)
    p = push_out(obstacles[k].shape, p);
  if (open.any && open.is_beyond(p))
    return p;
  const auto within = [](float v, float lo, float hi) { return v < lo ? lo : (v > hi ? hi : v); };
  return {within(p.x, min.x, max.x), within(p.y, min.y, max.y), within(p.z, min.z, max.z)};
}

inline Vec3<float> ContactView::resolve_off_walls(Vec3<float> p, float distance) const {
  const Vec3<float> off{distance, distance, distance};
  return ContactView{min + off, max - off, obstacles, obstacle_count, open, bodies}.resolve(p);
}

inline Vec3<float> ContactView::stop_off_walls(Vec3<float> p, Vec3<float> from,
                                               float distance) const {
  const auto lower = [=](float wall, float start) {
    return start < wall + distance ? start : wall + distance;
  };
  const auto upper = [=](float wall, float start) {
    return start > wall - distance ? start : wall - distance;
  };
  return ContactView{{lower(min.x, from.x), lower(min.y, from.y), lower(min.z, from.z)},
                     {upper(max.x, from.x), upper(max.y, from.y), upper(max.z, from.z)},
                     obstacles,
                     obstacle_count,
                     open,
                     bodies}
      .resolve(p);
}

inline Vec3<float> ContactView::resolve(const Vec3<float>& from, Vec3<float> p) const {
  for (const PosedBody& body : bodies)
    p = body.sweep(from, p);
  return resolve(p);
}

inline Vec3<float> ContactView::velocity_behind(const Vec3<float>& p,
                                                const Vec3<float>& push) const {
  const float length = square_root(dot(push, push));
  for (const PosedBody& body : bodies) {
    const Vec3<float> behind = p - (0.01f * body.spacing / length) * push;
    if (body.holds(behind))
      return body.velocity(body.pose.back(behind));
  }
  return {0, 0, 0};
}

inline bool ContactView::is_open(Vec3<float> p) const {
  const auto out = [](float v, float lo, float hi, float open_lo, float open_hi) {
    return (v < lo && v >= open_lo) || (v > hi && v <= open_hi);
  };
  if (out(p.x, min.x, max.x, open.min.x, open.max.x) ||
      out(p.y, min.y, max.y, open.min.y, open.max.y) ||
      out(p.z, min.z, max.z, open.min.z, open.max.z))
    return false;
  for (std::size_t k = 0; k < obstacle_count; ++k)
    if (contains(obstacles[k].shape, p))
      return false;
  return true;
}

}  // namespace spindrift::sim
