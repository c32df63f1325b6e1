// Shapes of obstacles as surfaces that particles are pushed out of.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim/from_glm.hpp"
#include "sim/real.hpp"
#include "sim/settings.hpp"
#include "sim/shapes/mesh_view.hpp"

namespace spindrift::sim {

/// A shape as plain data, which loops over particles can carry with them.
struct Solid {
  enum class Kind { box, sphere, cylinder, capsule, mesh };
  Kind kind = Kind::box;
  glm::vec3 a{0.f}, b{0.f};        ///< a box's corners, the ends of a line, a centre, m
  float radius = 0;                ///< m
  const MeshView* mesh = nullptr;  ///< where loops find it
};
/// As loops on the processor look at it.
Solid solid_of(const Shape& shape);
std::vector<Solid> solids_of(const std::vector<Obstacle>& obstacles);
/// As loops look at it that find meshes elsewhere.
/// @param meshes has `const MeshView* view_of(const MeshBody&)`
template <class Meshes>
Solid solid_of(const Shape& shape, Meshes& meshes) {
  Solid solid = solid_of(shape);
  if (const auto* mesh = std::get_if<TriangleMesh>(&shape))
    solid.mesh = meshes.view_of(*mesh->body);
  return solid;
}
template <class Meshes>
std::vector<Solid> solids_of(const std::vector<Obstacle>& obstacles, Meshes& meshes) {
  std::vector<Solid> solids;
  for (const Obstacle& obstacle : obstacles)
    solids.push_back(solid_of(obstacle.shape, meshes));
  return solids;
}

/// A direction across an axis of unit length.
SPINDRIFT_HD inline glm::vec3 across(const glm::vec3& axis) {
  const glm::vec3 helper =
      axis.y < 0.9f && axis.y > -0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  return glm::normalize(glm::cross(axis, helper));
}

SPINDRIFT_HD inline glm::vec3 push_out_of_box(const Solid& s, const glm::vec3& p) {
  const glm::vec3 low = p - s.a, high = s.b - p;
  const glm::vec3 depth = glm::min(low, high);
  if (depth.x <= 0 || depth.y <= 0 || depth.z <= 0)
    return p;
  if (depth.x <= depth.y && depth.x <= depth.z)
    return {low.x <= high.x ? s.a.x : s.b.x, p.y, p.z};
  if (depth.x > depth.y && depth.y <= depth.z)
    return {p.x, low.y <= high.y ? s.a.y : s.b.y, p.z};
  return {p.x, p.y, low.z <= high.z ? s.a.z : s.b.z};
}

SPINDRIFT_HD inline glm::vec3 push_out_of_sphere(const Solid& s, const glm::vec3& p) {
  const glm::vec3 offset = p - s.a;
  const float r = glm::length(offset);
  if (r >= s.radius)
    return p;
  const glm::vec3 n = r > 0 ? offset / r : glm::vec3(0, 1, 0);
  return s.a + s.radius * n;
}

SPINDRIFT_HD inline glm::vec3 push_out_of_cylinder(const Solid& s, const glm::vec3& p) {
  const float length = glm::length(s.b - s.a);
  const glm::vec3 axis = (s.b - s.a) / length;
  const float along = glm::dot(p - s.a, axis);
  const glm::vec3 radial = p - s.a - along * axis;
  const float r = glm::length(radial);
  if (along <= 0 || along >= length || r >= s.radius)
    return p;
  const float side = s.radius - r, below = along, above = length - along;
  if (side <= below && side <= above) {
    const glm::vec3 n = r > 0 ? radial / r : glm::vec3(axis.y, axis.z, axis.x);
    return s.a + along * axis + s.radius * n;
  }
  return below <= above ? p - below * axis : p + above * axis;
}

SPINDRIFT_HD inline glm::vec3 push_out_of_capsule(const Solid& s, const glm::vec3& p) {
  const glm::vec3 axis = s.b - s.a;
  const float along = glm::dot(p - s.a, axis) / glm::dot(axis, axis);
  const glm::vec3 nearest = s.a + glm::clamp(along, 0.f, 1.f) * axis;
  const glm::vec3 offset = p - nearest;
  const float r = glm::length(offset);
  if (r >= s.radius)
    return p;
  const glm::vec3 n = r > 0 ? offset / r : across(glm::normalize(axis));
  return nearest + s.radius * n;
}

/// As push_out(), of all shapes but meshes.
SPINDRIFT_HD SPINDRIFT_APART inline Vec3<float> push_out_of_formula(const Solid& s,
                                                                    const Vec3<float>& p) {
  const glm::vec3 q(p.x, p.y, p.z);
  switch (s.kind) {
    case Solid::Kind::box:
      return from_glm(push_out_of_box(s, q));
    case Solid::Kind::sphere:
      return from_glm(push_out_of_sphere(s, q));
    case Solid::Kind::cylinder:
      return from_glm(push_out_of_cylinder(s, q));
    case Solid::Kind::capsule:
      return from_glm(push_out_of_capsule(s, q));
    case Solid::Kind::mesh:
      break;
  }
  return p;
}

/// The nearest point on the surface of a shape for a point inside it; a point outside comes back as
/// it is.
SPINDRIFT_HD inline Vec3<float> push_out(const Solid& s, const Vec3<float>& p) {
  return s.kind == Solid::Kind::mesh ? from_glm(s.mesh->push_out({p.x, p.y, p.z}))
                                     : push_out_of_formula(s, p);
}
Vec3<float> push_out(const Shape& shape, Vec3<float> p);

/// Whether a point is inside a shape.
SPINDRIFT_HD inline bool contains(const Solid& s, const Vec3<float>& p) {
  if (s.kind == Solid::Kind::mesh)
    return s.mesh->grid.at({p.x, p.y, p.z}).distance < 0;
  const Vec3<float> moved = push_out(s, p) - p;
  return dot(moved, moved) > 0;
}
bool contains(const Shape& shape, Vec3<float> p);

}  // namespace spindrift::sim
