// A cylinder with flat ends.
#pragma once

#include "sim/geometry/round.hpp"
#include "sim/geometry/shapes/box.hpp"

namespace spindrift::geometry {

/// A cylinder with flat ends. Its members are described in `Box`.
struct Cylinder {
  glm::vec3 from{0.f};          ///< centre of one end, m
  glm::vec3 to{0.f, 1.f, 0.f};  ///< centre of the other end, m
  float radius = 0.5f;          ///< m

  static constexpr std::string_view name = "cylinder";
  static constexpr auto fields = std::tuple{
      Field{"from", &Cylinder::from, "centre of one end", places, "m", Presence::required},
      Field{"to", &Cylinder::to, "centre of the other end", places, "m", Presence::required},
      Field{"radius", &Cylinder::radius, "radius", lengths, "m", Presence::required}};

  std::string problem() const { return from == to ? "from and to are the same point" : ""; }

  SPINDRIFT_HD glm::vec3 push_out(const glm::vec3& p) const {
    const float length = glm::length(to - from);
    const glm::vec3 axis = (to - from) / length;
    const float along = glm::dot(p - from, axis);
    const glm::vec3 radial = p - from - along * axis;
    const float r = glm::length(radial);
    if (along <= 0 || along >= length || r >= radius)
      return p;
    const float side = radius - r, below = along, above = length - along;
    if (side <= below && side <= above) {
      return from + along * axis + radius * away_from_axis(axis, radial, r, length);
    }
    return below <= above ? p - below * axis : p + above * axis;
  }

  /// The part of the line from `start` to `start + way` (m) that is inside.
  SPINDRIFT_HD Chord chord(const glm::vec3& start, const glm::vec3& way) const {
    const float length = glm::length(to - from);
    const glm::vec3 axis = (to - from) / length, offset = start - from;
    const float along = glm::dot(offset, axis), way_along = glm::dot(way, axis);
    Chord chord;
    chord.meet_slab(along, way_along, 0, length, axis);
    chord.meet_round(offset - along * axis, way - way_along * axis, radius);
    return chord;
  }

  SPINDRIFT_HD Entry entry(const glm::vec3& start, const glm::vec3& way) const {
    Entry entry;
    join_entry(chord(start, way), way, entry);
    return entry;
  }

  SPINDRIFT_HD Cylinder thickened(float margin) const {
    const glm::vec3 end = margin * glm::normalize(to - from);
    return {from - end, to + end, radius + margin};
  }

  Box bounds() const {
    const glm::vec3 reach = reach_of_disc(glm::normalize(to - from), radius);
    return {glm::min(from, to) - reach, glm::max(from, to) + reach};
  }

  /// The distance between the two ends, m.
  double length() const { return glm::distance(glm::dvec3(from), glm::dvec3(to)); }
  double volume() const { return std::numbers::pi * double{radius} * radius * length(); }
  double area() const {
    return 2 * std::numbers::pi * double{radius} * (double{radius} + length());
  }

  glm::bvec3 flat_along() const {
    const int axis = axis_along(from, to);
    return {axis == 0, axis == 1, axis == 2};
  }

  std::vector<SurfaceSample> samples(float spacing) const {
    const float inset = 0.5f * spacing, span = glm::length(to - from);
    const glm::vec3 in = (to - from) * (std::min(inset, 0.4f * span) / span);
    return samples_at(
        points_on_cone(from + in, to - in, glm::vec2(radius_below(radius, inset)), spacing));
  }

  void tessellate(Tessellation& into) const { tessellate_cone(into, from, to, glm::vec2(radius)); }

  std::optional<Cylinder> mirrored(const Mirror& mirror) const {
    return Cylinder{mirror(from), mirror(to), radius};
  }
};

}  // namespace spindrift::geometry
