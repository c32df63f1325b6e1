// Where a straight way enters a solid from outside, and how it goes on along the surface.
//
// What a particle does between two positions is a straight way. If no such way ever enters a solid,
// no particle is ever on a wall's other side, however thin the wall is.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>

#include "sim/solid.hpp"

namespace spindrift::sim {

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

/// A shape that is no mesh, and a margin around it.
SPINDRIFT_HD inline Solid thickened(Solid s, float margin) {
  if (s.kind == Solid::Kind::box) {
    s.a -= margin;
    s.b += margin;
    return s;
  }
  s.radius += margin;
  if (s.kind == Solid::Kind::cylinder) {
    const glm::vec3 end = margin * glm::normalize(s.b - s.a);
    s.a -= end;
    s.b += end;
  }
  return s;
}

SPINDRIFT_HD inline Chord chord_of_ball(const glm::vec3& center, float radius,
                                        const glm::vec3& from, const glm::vec3& way) {
  Chord chord;
  chord.meet_round(from - center, way, radius);
  return chord;
}

SPINDRIFT_HD inline Chord chord_of_box(const Solid& s, const glm::vec3& from,
                                       const glm::vec3& way) {
  Chord chord;
  chord.meet_slab(from.x, way.x, s.a.x, s.b.x, {1, 0, 0});
  chord.meet_slab(from.y, way.y, s.a.y, s.b.y, {0, 1, 0});
  chord.meet_slab(from.z, way.z, s.a.z, s.b.z, {0, 0, 1});
  return chord;
}

SPINDRIFT_HD inline Chord chord_of_cylinder(const Solid& s, const glm::vec3& from,
                                            const glm::vec3& way) {
  const float length = glm::length(s.b - s.a);
  const glm::vec3 axis = (s.b - s.a) / length, offset = from - s.a;
  const float along = glm::dot(offset, axis), way_along = glm::dot(way, axis);
  Chord chord;
  chord.meet_slab(along, way_along, 0, length, axis);
  chord.meet_round(offset - along * axis, way - way_along * axis, s.radius);
  return chord;
}

/// Of a shape that is no mesh.
SPINDRIFT_HD inline Entry entry_into(const Solid& s, const glm::vec3& from, const glm::vec3& way) {
  Entry entry;
  if (s.kind == Solid::Kind::box)
    join_entry(chord_of_box(s, from, way), way, entry);
  if (s.kind == Solid::Kind::cylinder || s.kind == Solid::Kind::capsule)
    join_entry(chord_of_cylinder(s, from, way), way, entry);
  if (s.kind == Solid::Kind::sphere || s.kind == Solid::Kind::capsule)
    join_entry(chord_of_ball(s.a, s.radius, from, way), way, entry);
  if (s.kind == Solid::Kind::capsule)
    join_entry(chord_of_ball(s.b, s.radius, from, way), way, entry);
  return entry;
}

/// Whether a way may come nearer to a solid than the margin: its box and that of the way overlap.
SPINDRIFT_HD inline bool may_meet(const Solid& s, const glm::vec3& from, const glm::vec3& to,
                                  float margin) {
  glm::vec3 low, high;
  if (s.kind == Solid::Kind::mesh) {
    low = s.mesh->tree.nodes[0].low;
    high = s.mesh->tree.nodes[0].high;
  } else {
    const glm::vec3 b = s.kind == Solid::Kind::sphere ? s.a : s.b;
    low = glm::min(s.a, b) - s.radius;
    high = glm::max(s.a, b) + s.radius;
  }
  const glm::vec3 begin = glm::min(from, to), end = glm::max(from, to);
  return begin.x <= high.x + margin && begin.y <= high.y + margin && begin.z <= high.z + margin &&
         end.x >= low.x - margin && end.y >= low.y - margin && end.z >= low.z - margin;
}

/// Where a way ends that is not to enter a solid: at its end, or, where it would enter, that far
/// along the plane that touches the surface there, one and a half margins off it; m.
SPINDRIFT_HD SPINDRIFT_APART inline glm::vec3 kept_out(const Solid& s, glm::vec3 from,
                                                       const glm::vec3& to, float margin) {
  Entry entry;
  float off = 0.5f * margin;
  if (s.kind == Solid::Kind::mesh) {
    off = 1.5f * margin;
    entry = s.mesh->entry(from, to, margin);
  } else {
    const Solid thick = thickened(s, margin);
    const Vec3<float> out = push_out_of_formula(thick, from_glm(from));
    const glm::vec3 push = to_glm(out) - from;
    if (push != glm::vec3(0.f))  // but for rounding it was outside
      from = to_glm(out) + off * glm::normalize(push);
    entry = entry_into(thick, from, to - from);
  }
  if (!entry.found)
    return to;
  const glm::vec3 surface = from + entry.part * (to - from);
  return to + (off - glm::dot(to - surface, entry.normal)) * entry.normal;
}

}  // namespace spindrift::sim
