// Intersection of a straight path with a solid: where the path enters the solid from outside.
//
// A particle moves along a straight path from one position to the next. If no such path ever enters
// a solid, no particle is ever on a wall's other side, however thin the wall is.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "sim/geometry/host_device.hpp"

namespace spindrift::geometry {

/// The point at which a straight path enters a solid from outside.
struct Entry {
  bool found = false;
  float part = 0;         ///< the fraction of the path that lies before the entry
  glm::vec3 normal{0.f};  ///< outward unit normal of the surface at the entry
};

/// The part of a line that is inside a convex body: the interval of the line's parameter, in which
/// 0 is the beginning of a path along the line and 1 is its end. A new chord is the whole line;
/// each `meet` cuts it down to what is inside one more face.
struct Chord {
  float in = -std::numeric_limits<float>::infinity(), out = std::numeric_limits<float>::infinity();
  glm::vec3 normal{0.f};  ///< outward unit normal of the surface where the line enters

  /// Intersects the chord with the interval from `begin` to `end`.
  SPINDRIFT_HD void meet(float begin, float end, const glm::vec3& normal_at_begin) {
    if (begin > in) {
      in = begin;
      normal = normal_at_begin;
    }
    out = std::min(out, end);
  }
  /// Empties the chord: the line misses the body.
  SPINDRIFT_HD void miss() { out = -std::numeric_limits<float>::infinity(); }

  /// Intersects the chord with the slab between two planes, which lie at `low` and `high` (m) along
  /// the unit vector `direction`.
  /// @param from the coordinate of the path's beginning along `direction`, m
  /// @param way the path's extent along `direction`, m
  SPINDRIFT_HD void meet_slab(float from, float way, float low, float high,
                              const glm::vec3& direction) {
    if (way > 0)
      meet((low - from) / way, (high - from) / way, -direction);
    else if (way < 0)
      meet((high - from) / way, (low - from) / way, direction);
    else if (from <= low || from >= high)
      miss();
  }

  /// Intersects the chord with a ball, or with an infinite cylinder.
  /// @param offset from the centre to the path's beginning, m; for a cylinder, its component across
  /// the axis
  /// @param way from the path's beginning to its end, m; for a cylinder, its component across the
  /// axis
  SPINDRIFT_HD void meet_round(const glm::vec3& offset, const glm::vec3& way, float radius) {
    const float a = glm::dot(way, way), half_b = glm::dot(offset, way),
                c = glm::dot(offset, offset) - radius * radius;
    const float discriminant = half_b * half_b - a * c;
    if (a > 0 ? !(discriminant > 0) : c >= 0)
      return miss();
    if (!(a > 0))
      return;
    const float root = std::sqrt(discriminant), begin = (-half_b - root) / a;
    const glm::vec3 surface = offset + std::max(begin, 0.f) * way;
    const float length = glm::length(surface);
    meet(begin, (-half_b + root) / a, length > 0 ? surface / length : glm::vec3(0.f));
  }
};

/// Replaces `first` by the entry of a path into a convex body, if the path enters it and does so
/// earlier.
/// @param chord the part of the path's line that is inside the body
/// @param way from the path's beginning to its end, m
SPINDRIFT_HD inline void join_entry(const Chord& chord, const glm::vec3& way, Entry& first) {
  const float begin = std::max(chord.in, 0.f);
  const bool enters =
      chord.in < chord.out && chord.out > 0 && begin <= 1 && glm::dot(way, chord.normal) < 0;
  if (enters && (!first.found || begin < first.part))
    first = {true, begin, chord.normal};
}

}  // namespace spindrift::geometry
