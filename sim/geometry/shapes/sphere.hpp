// A ball as a shape.
#pragma once

#include "sim/geometry/round.hpp"
#include "sim/geometry/shapes/box.hpp"

namespace spindrift::geometry {

/// A solid ball. Its members are described in `Box`.
struct Sphere {
  glm::vec3 center{0.f};  ///< m
  float radius = 0.5f;    ///< m

  static constexpr std::string_view name = "sphere";
  static constexpr auto fields =
      std::tuple{Field{"center", &Sphere::center, "centre", places, "m", Presence::required},
                 Field{"radius", &Sphere::radius, "radius", lengths, "m", Presence::required}};

  std::string problem() const { return ""; }

  SPINDRIFT_HD glm::vec3 push_out(const glm::vec3& p) const {
    const glm::vec3 offset = p - center;
    const float r = glm::length(offset);
    if (r >= radius)
      return p;
    const glm::vec3 n = r > 0 ? offset / r : glm::vec3(0, 1, 0);
    return center + radius * n;
  }

  SPINDRIFT_HD Entry entry(const glm::vec3& from, const glm::vec3& way) const {
    Chord chord;
    chord.meet_round(from - center, way, radius);
    Entry entry;
    join_entry(chord, way, entry);
    return entry;
  }

  SPINDRIFT_HD Sphere thickened(float margin) const { return {center, radius + margin}; }

  Box bounds() const { return {center - radius, center + radius}; }

  double volume() const { return 4. / 3 * std::numbers::pi * std::pow(double{radius}, 3); }
  double area() const { return 4 * std::numbers::pi * std::pow(double{radius}, 2); }

  glm::bvec3 flat_along() const { return glm::bvec3(false); }

  std::vector<SurfaceSample> samples(float spacing) const {
    return samples_at(
        points_on_capsule(center, glm::mat3(1), 0, radius_below(radius, 0.5f * spacing), spacing));
  }

  void tessellate(Tessellation& into) const {
    tessellate_capsule(into, center, center, radius, glm::mat3(1.f));
  }

  std::optional<Sphere> mirrored(const Mirror& mirror) const {
    return Sphere{mirror(center), radius};
  }
};

}  // namespace spindrift::geometry
