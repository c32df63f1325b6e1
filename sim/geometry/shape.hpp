// All shapes. What a shape can do stands in its own file in shapes/; a new one is registered here,
// by a line in the list of `Shape`.
#pragma once

#include <variant>

#include "sim/geometry/shapes/box.hpp"
#include "sim/geometry/shapes/capsule.hpp"
#include "sim/geometry/shapes/cone.hpp"
#include "sim/geometry/shapes/cylinder.hpp"
#include "sim/geometry/shapes/sphere.hpp"
#include "sim/geometry/shapes/triangle_mesh.hpp"

namespace spindrift::geometry {

using Shape = std::variant<Box, Sphere, Cylinder, Capsule, Cone, TriangleMesh>;

/// What is wrong with a shape, for people; empty: nothing.
std::string problem_of(const Shape& shape);

/// The key of its kind in a scene: "box".
std::string_view name_of(const Shape& shape);

/// The smallest box around a shape.
Box bounds_of(const Shape& shape);

/// m³; of a mesh whose parts overlap, the sum of theirs.
double volume_of(const Shape& shape);

/// Of its surface, m².
double area_of(const Shape& shape);

/// The axes along which a shape ends in flat faces, or nearly so, between which a lattice fits.
glm::bvec3 flat_along(const Shape& shape);

/// Points below the surface, half a spacing deep, about one per spacing².
std::vector<SurfaceSample> sample_surface(const Shape& shape, float spacing);

void tessellate(Tessellation& into, const Shape& shape);

/// The shape's image; none for a mesh.
std::optional<Shape> mirrored(const Shape& shape, const Mirror& mirror);

/// Whether a point, m, is inside a shape.
bool is_inside(const Shape& shape, const glm::vec3& p);

/// The nearest point on the surface of a shape for a point inside it; a point outside comes back as
/// it is.
glm::vec3 push_out(const Shape& shape, const glm::vec3& p);

}  // namespace spindrift::geometry
