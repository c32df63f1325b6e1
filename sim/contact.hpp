// Walls' and obstacles' surfaces as a last contact: pressure from boundary particles keeps the
// liquid off them; a lone particle has no pressure, and is stopped here, without a bounce and
// without friction.
#pragma once

#include "sim/backend.hpp"
#include "sim/obstacles.hpp"
#include "sim/open_faces.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

struct ContactView {
  Vec3<float> min, max;  ///< inner faces of the domain, m
  ObstacleView obstacles = {};
  OpenFaces open = {};

  /// The point itself, or the nearest one that is inside the domain and outside every obstacle, m.
  /// Beyond an open face there are no walls.
  SPINDRIFT_HD Vec3<float> resolve(Vec3<float> p) const {
    p = obstacles.hold(p);
    if (open.any && open.is_beyond(p))
      return p;
    return {within(p.x, min.x, max.x), within(p.y, min.y, max.y), within(p.z, min.z, max.z)};
  }

  /// The point itself, or the nearest one that is `distance`, m, off the domain's walls and outside
  /// every obstacle.
  SPINDRIFT_HD Vec3<float> resolve_off_walls(Vec3<float> p, float distance) const {
    const Vec3<float> off{distance, distance, distance};
    return ContactView{min + off, max - off, obstacles, open}.resolve(p);
  }

  /// The same for a point on its way from another: no further off a wall than that one is.
  SPINDRIFT_HD Vec3<float> stop_off_walls(Vec3<float> p, Vec3<float> from, float distance) const {
    return ContactView{{lower(min.x, from.x, distance), lower(min.y, from.y, distance),
                        lower(min.z, from.z, distance)},
                       {upper(max.x, from.x, distance), upper(max.y, from.y, distance),
                        upper(max.z, from.z, distance)},
                       obstacles,
                       open}
        .resolve(p);
  }

  /// The nearest such point for a particle that comes from `from`, which moving bodies do not pass.
  SPINDRIFT_HD Vec3<float> resolve(const Vec3<float>& from, const Vec3<float>& p) const {
    return resolve(obstacles.sweep(from, p));
  }

 private:
  SPINDRIFT_HD static float within(float v, float lo, float hi) {
    return v < lo ? lo : (v > hi ? hi : v);
  }
  SPINDRIFT_HD static float lower(float wall, float start, float distance) {
    return start < wall + distance ? start : wall + distance;
  }
  SPINDRIFT_HD static float upper(float wall, float start, float distance) {
    return start > wall - distance ? start : wall - distance;
  }
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
