// Repairs the triangles of a mesh file so that they are the closed, consistently wound surface of a
// solid.
#pragma once

#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::geometry {

/// Joins vertices at the same position, leaves out triangles that become degenerate by that or are
/// doubled, and flips triangles so that neighbours wind the same way.
///
/// What is inside does not depend on how the triangles were wound before: each connected part is a
/// body, and bodies that overlap are united. A part that lies wholly within others is a body of its
/// own if their number is even, and a cavity if it is odd. Bodies wind counter-clockwise seen from
/// outside, cavities the other way, so that a point is inside where the winding number is above 0.
/// @throws MeshError when edges are open, when the triangles cannot be wound consistently, or when
/// they enclose no volume
TriangleSurface closed_surface(const TriangleSurface& triangles);

/// The number of connected parts of a closed surface that are cavities.
std::size_t inner_shells(const TriangleSurface& closed);

}  // namespace spindrift::geometry
