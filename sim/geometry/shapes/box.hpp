// An axis-aligned box, both as a shape and as the bounding box of any other shape.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/geometry/entry.hpp"
#include "sim/geometry/keys.hpp"
#include "sim/geometry/mirror.hpp"
#include "sim/geometry/surface_sample.hpp"
#include "sim/geometry/tessellation.hpp"
#include "sim/geometry/vector_text.hpp"

namespace spindrift::geometry {

/// An axis-aligned box. Every alternative of `Shape` has the members that are described here, but
/// for a mesh, whose collisions are those of `MeshSolid`.
struct Box {
  glm::vec3 min{0.f};  ///< lowest corner, m
  glm::vec3 max{1.f};  ///< highest corner, m

  /// The key of this kind of shape in a scene file.
  static constexpr std::string_view name = "box";
  /// The keys of its members in a scene file.
  static constexpr auto fields =
      std::tuple{Field{"min", &Box::min, "lowest corner", places, "m", Presence::required},
                 Field{"max", &Box::max, "highest corner", places, "m", Presence::required}};

  /// A message for people that says what is wrong with the shape; empty if nothing is.
  std::string problem() const {
    for (int axis = 0; axis < 3; ++axis)
      if (!(min[axis] < max[axis]))
        return "min " + vector_text(min) + " is not below max " + vector_text(max) + " in " +
               "xyz"[axis];
    return "";
  }

  /// The point on the surface nearest to `p`, if `p` is inside; otherwise `p` itself, m.
  SPINDRIFT_HD glm::vec3 push_out(const glm::vec3& p) const {
    const glm::vec3 low = p - min, high = max - p;
    const glm::vec3 depth = glm::min(low, high);
    if (depth.x <= 0 || depth.y <= 0 || depth.z <= 0)
      return p;
    if (depth.x <= depth.y && depth.x <= depth.z)
      return {low.x <= high.x ? min.x : max.x, p.y, p.z};
    if (depth.x > depth.y && depth.y <= depth.z)
      return {p.x, low.y <= high.y ? min.y : max.y, p.z};
    return {p.x, p.y, low.z <= high.z ? min.z : max.z};
  }

  /// Where the straight path from `from` to `from + way` enters the shape from outside; both in m.
  SPINDRIFT_HD Entry entry(const glm::vec3& from, const glm::vec3& way) const {
    Chord chord;
    chord.meet_slab(from.x, way.x, min.x, max.x, {1, 0, 0});
    chord.meet_slab(from.y, way.y, min.y, max.y, {0, 1, 0});
    chord.meet_slab(from.z, way.z, min.z, max.z, {0, 0, 1});
    Entry entry;
    join_entry(chord, way, entry);
    return entry;
  }

  /// The shape with its surface moved out by the margin, m.
  SPINDRIFT_HD Box thickened(float margin) const { return {min - margin, max + margin}; }

  /// The smallest axis-aligned box around the shape, m.
  Box bounds() const { return *this; }

  /// The volume, m³.
  double volume() const {
    const glm::dvec3 d = glm::max(glm::dvec3(max) - glm::dvec3(min), 0.);
    return d.x * d.y * d.z;
  }

  /// The area of the surface, m².
  double area() const {
    const glm::dvec3 d = glm::dvec3(max) - glm::dvec3(min);
    return 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
  }

  /// The axes along which the shape ends in faces that are flat, or nearly so, between which a
  /// lattice of particles fits.
  glm::bvec3 flat_along() const { return glm::bvec3(true); }

  /// Samples half a spacing below the surface, about one per spacing²; the spacing is in m.
  std::vector<SurfaceSample> samples(float spacing) const;

  /// Appends the triangles of the surface.
  void tessellate(Tessellation& into) const {
    const glm::vec3 center = 0.5f * (min + max), half = 0.5f * (max - min);
    for (int axis = 0; axis < 3; ++axis)
      for (const float side : {-1.f, 1.f}) {
        glm::vec3 normal{0.f}, u{0.f}, v{0.f};
        normal[axis] = side;
        u[(axis + 1) % 3] = side;  // u × v = the outward normal on both sides
        v[(axis + 2) % 3] = 1.f;
        const auto corner = [&](float a, float b) {
          return into.add_vertex(center + half * (normal + a * u + b * v), normal);
        };
        const unsigned a = corner(-1.f, -1.f), b = corner(1.f, -1.f), c = corner(1.f, 1.f),
                       d = corner(-1.f, 1.f);
        into.add_quad(a, b, c, d);
      }
  }

  /// The mirror image; nullopt if this kind of shape has none.
  std::optional<Box> mirrored(const Mirror& mirror) const {
    const glm::vec3 a = mirror(min), b = mirror(max);
    return Box{glm::min(a, b), glm::max(a, b)};
  }
};

/// Whether two boxes have no point in common.
inline bool is_apart(const Box& a, const Box& b) {
  return glm::any(glm::lessThan(a.max, b.min)) || glm::any(glm::greaterThan(a.min, b.max));
}

/// The number of steps along each axis, at least one, of a lattice that is stretched to end exactly
/// at both corners of a box of this size (m); a step is about a spacing (m) long.
inline glm::ivec3 steps_across(const glm::vec3& size, float spacing) {
  return glm::max(glm::ivec3(glm::round(size / spacing)), glm::ivec3(1));
}

/// The points on the surface of a box that belong to the lattice of steps_across(), m.
inline std::vector<glm::vec3> points_on_box(const Box& box, float spacing) {
  const glm::ivec3 n = steps_across(box.max - box.min, spacing);
  const glm::vec3 step = (box.max - box.min) / glm::vec3(n);
  std::vector<glm::vec3> points;
  for (int k = 0; k <= n.z; ++k)
    for (int j = 0; j <= n.y; ++j) {
      const bool on_face = j == 0 || j == n.y || k == 0 || k == n.z;
      for (int i = 0; i <= n.x; i += on_face ? 1 : n.x)
        points.push_back(box.min + step * glm::vec3(i, j, k));
    }
  return points;
}

inline std::vector<SurfaceSample> Box::samples(float spacing) const {
  const glm::vec3 inset = glm::min(glm::vec3(0.5f * spacing), 0.5f * (max - min));
  return samples_at(points_on_box({min + inset, max - inset}, spacing));
}

}  // namespace spindrift::geometry
