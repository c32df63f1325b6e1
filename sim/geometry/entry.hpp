// Where a straight way enters a solid from outside.
//
// What a particle does between two positions is a straight way. If no such way ever enters a solid,
// no particle is ever on a wall's other side, however thin the wall is.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "sim/geometry/host_device.hpp"

namespace spindrift::geometry {

/// Where a straight way enters a solid from outside.
struct Entry {
  bool found = false;
  float part = 0;         ///< of the way that is before it
  glm::vec3 normal{0.f};  ///< of the surface there, of unit length
};

/// The part of a line that is inside something convex, in multiples of a way along the line.
struct Chord {
  float in = -std::numeric_limits<float>::infinity(), out = std::numeric_limits<float>::infinity();
  glm::vec3 normal{0.f};  ///< of the surface where the line comes in, of unit length

  /// Leaves what is inside something else too.
  SPINDRIFT_HD void meet(float begin, float end, const glm::vec3& normal_at_begin) {
    if (begin > in) {
      in = begin;
      normal = normal_at_begin;
    }
    out = std::min(out, end);
  }
  SPINDRIFT_HD void miss() { out = -std::numeric_limits<float>::infinity(); }

  /// Leaves what is between two planes, at `low` and `high` along a direction.
  SPINDRIFT_HD void meet_slab(float from, float way, float low, float high,
                              const glm::vec3& direction) {
    if (way > 0)
      meet((low - from) / way, (high - from) / way, -direction);
    else if (way < 0)
      meet((high - from) / way, (low - from) / way, direction);
    else if (from <= low || from >= high)
      miss();
  }

  /// Leaves what is nearer than a radius to a point, or to a line; the offset from it, m, and the
  /// way, m, are at right angles to that line.
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

/// Takes over the entry of a way into something convex, if it is an earlier one.
SPINDRIFT_HD inline void join_entry(const Chord& chord, const glm::vec3& way, Entry& first) {
  const float begin = std::max(chord.in, 0.f);
  const bool enters =
      chord.in < chord.out && chord.out > 0 && begin <= 1 && glm::dot(way, chord.normal) < 0;
  if (enters && (!first.found || begin < first.part))
    first = {true, begin, chord.normal};
}

}  // namespace spindrift::geometry
