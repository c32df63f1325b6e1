// The variant of all shapes and the functions that work on any of them. Each shape is defined in
// its own file in shapes/, with the members that `Box` documents; a new shape is added to the list
// of `Shape` here.
#pragma once

#include <variant>

#include "sim/geometry/shapes/box.hpp"
#include "sim/geometry/shapes/capsule.hpp"
#include "sim/geometry/shapes/cone.hpp"
#include "sim/geometry/shapes/cylinder.hpp"
#include "sim/geometry/shapes/sphere.hpp"
#include "sim/geometry/shapes/triangle_mesh.hpp"

namespace spindrift::geometry {

/// A solid of any kind, as the scene places it.
using Shape = std::variant<Box, Sphere, Cylinder, Capsule, Cone, TriangleMesh>;

/// A message for people that says what is wrong with a shape; empty if nothing is.
std::string problem_of(const Shape& shape);

/// The key of the shape's kind in a scene file, such as "box".
std::string_view name_of(const Shape& shape);

/// The smallest axis-aligned box around a shape, m.
Box bounds_of(const Shape& shape);

/// The volume of a shape, m³; for a mesh whose parts overlap, the sum of the parts' volumes.
double volume_of(const Shape& shape);

/// The area of a shape's surface, m².
double area_of(const Shape& shape);

/// The axes along which a lattice of particles can fit a shape from face to face, because the shape
/// ends in faces that are flat, or nearly so.
glm::bvec3 flat_along(const Shape& shape);

/// Samples half a spacing below the surface, about one per spacing². `spacing` is the spacing of
/// the particles, m.
std::vector<SurfaceSample> sample_surface(const Shape& shape, float spacing);

/// Appends the triangles of a shape's surface.
void tessellate(Tessellation& into, const Shape& shape);

/// The mirror image of a shape; nullopt for a mesh.
std::optional<Shape> mirrored(const Shape& shape, const Mirror& mirror);

/// Whether a point (m) is inside a shape.
bool is_inside(const Shape& shape, const glm::vec3& p);

/// The point on the surface of a shape that is nearest to `p`, if `p` is inside; otherwise `p`
/// itself, m.
glm::vec3 push_out(const Shape& shape, const glm::vec3& p);

}  // namespace spindrift::geometry
