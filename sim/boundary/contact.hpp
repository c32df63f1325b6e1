// The surfaces of walls and obstacles as a last resort against penetration. Pressure from boundary
// particles keeps the liquid off them; a lone particle has no pressure and is stopped here, without
// a bounce and without friction.
#pragma once

#include "sim/backend/backend.hpp"
#include "sim/boundary/obstacles.hpp"
#include "sim/core/open_faces.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// All solid surfaces, as plain data that loops over particles can capture.
struct ContactView {
  Vec3<float> min, max;  ///< corners of the domain's inside, m
  ObstacleView obstacles = {};
  OpenFaces open = {};

  /// The point itself, if it is inside the domain and outside every obstacle; otherwise a point
  /// near it that is, m. Beyond an open face there are no walls.
  SPINDRIFT_HD Vec3<float> resolve(const Vec3<float>& p) const {
    return in_domain(obstacles.hold(p));
  }

  /// Where a particle ends that moves from `from` to `p`, m: no part of its path is in an obstacle.
  /// At a surface it goes on along that surface; where this leads into too many others in turn, it
  /// stays at `from`, or where a moving obstacle pushes it from there.
  /// @param since where moving bodies are when the particle is at `from`
  SPINDRIFT_HD Vec3<float> resolve(const Vec3<float>& from, Vec3<float> p,
                                   Since since = Since::end) const {
    if (!obstacles.any())
      return in_domain(p);
    // Most particles are far from all obstacles, which one test of each shows; the rest takes
    // three.
    const Vec3<float> inside = in_domain(p);
    if (inside.x == p.x && inside.y == p.y && inside.z == p.z && obstacles.is_clear(from, p))
      return p;
    p = resolve(obstacles.keep_out_of_bodies(from, p, since));
    constexpr int most_surfaces = 8;
    for (int k = 0; k < most_surfaces; ++k) {
      const Vec3<float> before = p;
      p = in_domain(obstacles.keep_out(from, p, since));
      if (obstacles.any_moves())
        p = in_domain(obstacles.hold_off_bodies(p));
      if (p.x == before.x && p.y == before.y && p.z == before.z)
        return p;
    }
    return obstacles.keep_out_of_bodies(from, from, since);
  }

  /// Does the same with walls of the domain that are a distance (m) further in.
  SPINDRIFT_HD Vec3<float> resolve_off_walls(const Vec3<float>& from, const Vec3<float>& p,
                                             float distance) const {
    const Vec3<float> off{distance, distance, distance};
    return ContactView{min + off, max - off, obstacles, open}.resolve(from, p);
  }

  /// Does the same, but keeps the particle no further off a wall than `start`, its position at the
  /// beginning of the step, is (m).
  SPINDRIFT_HD Vec3<float> stop_off_walls(const Vec3<float>& from, const Vec3<float>& p,
                                          const Vec3<float>& start, float distance) const {
    return ContactView{{lower(min.x, start.x, distance), lower(min.y, start.y, distance),
                        lower(min.z, start.z, distance)},
                       {upper(max.x, start.x, distance), upper(max.y, start.y, distance),
                        upper(max.z, start.z, distance)},
                       obstacles,
                       open}
        .resolve(from, p);
  }

 private:
  SPINDRIFT_HD Vec3<float> in_domain(const Vec3<float>& p) const {
    if (open.any && open.is_beyond(p))
      return p;
    return {within(p.x, min.x, max.x), within(p.y, min.y, max.y), within(p.z, min.z, max.z)};
  }
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
