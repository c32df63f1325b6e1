// Walls' and obstacles' surfaces as a last contact: pressure from boundary particles keeps the
// liquid off them; a lone particle has no pressure, and is stopped here, without a bounce and
// without friction.
#pragma once

#include <span>
#include <vector>

#include "sim/open_faces.hpp"
#include "sim/real.hpp"
#include "sim/settings.hpp"

namespace spindrift::sim {

struct ContactView {
  Vec3<float> min, max;  ///< inner faces of the domain, m
  const Obstacle* obstacles = nullptr;
  std::size_t obstacle_count = 0;
  OpenFaces open = {};

  /// The point itself, or the nearest one that is inside the domain and outside every obstacle, m.
  /// Beyond an open face there are no walls.
  Vec3<float> resolve(Vec3<float> p) const;

  /// Whether a point is inside the domain, or in front of an open face, and outside every obstacle.
  bool is_open(Vec3<float> p) const;
};

/// The nearest point on the surface of a shape for a point inside it; a point outside comes back as
/// it is.
Vec3<float> push_out(const Shape& shape, Vec3<float> p);

/// Whether a point is inside a shape.
bool contains(const Shape& shape, Vec3<float> p);

inline Vec3<float> ContactView::resolve(Vec3<float> p) const {
  for (std::size_t k = 0; k < obstacle_count; ++k)
    p = push_out(obstacles[k].shape, p);
  if (open.any && open.is_beyond(p))
    return p;
  const auto within = [](float v, float lo, float hi) { return v < lo ? lo : (v > hi ? hi : v); };
  return {within(p.x, min.x, max.x), within(p.y, min.y, max.y), within(p.z, min.z, max.z)};
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
