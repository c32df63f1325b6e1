// A capsule: a cylinder with half a ball on each end.
#pragma once

#include "sim/geometry/shapes/cylinder.hpp"
#include "sim/geometry/shapes/sphere.hpp"

namespace spindrift::geometry {

/// All points within a radius of a line segment. Its members are described in `Box`.
struct Capsule {
  glm::vec3 from{0.f};          ///< one end of the segment, m
  glm::vec3 to{0.f, 1.f, 0.f};  ///< the other end of the segment, m
  float radius = 0.5f;          ///< m

  static constexpr std::string_view name = "capsule";
  static constexpr auto fields =
      std::tuple{Field{"from", &Capsule::from, "one end of the line that all points are near",
                       places, "m", Presence::required},
                 Field{"to", &Capsule::to, "the line's other end", places, "m", Presence::required},
                 Field{"radius", &Capsule::radius, "largest distance from the line", lengths, "m",
                       Presence::required}};

  std::string problem() const { return from == to ? "from and to are the same point" : ""; }

  SPINDRIFT_HD glm::vec3 push_out(const glm::vec3& p) const {
    const glm::vec3 axis = to - from;
    const float along = glm::dot(p - from, axis) / glm::dot(axis, axis);
    const glm::vec3 nearest = from + glm::clamp(along, 0.f, 1.f) * axis;
    const glm::vec3 offset = p - nearest;
    const float r = glm::length(offset);
    if (r >= radius)
      return p;
    return nearest + radius * away_from_axis(glm::normalize(axis), offset, r, glm::length(axis));
  }

  SPINDRIFT_HD Entry entry(const glm::vec3& start, const glm::vec3& way) const {
    Entry entry;
    join_entry(Cylinder{from, to, radius}.chord(start, way), way, entry);
    for (const glm::vec3& end : {from, to}) {
      Chord chord;
      chord.meet_round(start - end, way, radius);
      join_entry(chord, way, entry);
    }
    return entry;
  }

  SPINDRIFT_HD Capsule thickened(float margin) const { return {from, to, radius + margin}; }

  Box bounds() const { return {glm::min(from, to) - radius, glm::max(from, to) + radius}; }

  /// The length of the segment, m.
  double length() const { return glm::distance(glm::dvec3(from), glm::dvec3(to)); }
  double volume() const {
    return std::numbers::pi * double{radius} * radius * (length() + 4. / 3 * double{radius});
  }
  double area() const {
    return 2 * std::numbers::pi * double{radius} * (length() + 2 * double{radius});
  }

  glm::bvec3 flat_along() const { return glm::bvec3(false); }

  std::vector<SurfaceSample> samples(float spacing) const {
    const float span = glm::length(to - from);
    const glm::vec3 axis = (to - from) / span;
    const glm::vec3 u = across(axis), v = glm::cross(axis, u);
    return samples_at(points_on_capsule(0.5f * (from + to), {u, axis, v}, span,
                                        radius_below(radius, 0.5f * spacing), spacing));
  }

  void tessellate(Tessellation& into) const {
    tessellate_capsule(into, from, to, radius, frame_along(glm::normalize(to - from)));
  }

  std::optional<Capsule> mirrored(const Mirror& mirror) const {
    return Capsule{mirror(from), mirror(to), radius};
  }
};

}  // namespace spindrift::geometry
