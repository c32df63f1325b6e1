// Triangles as files hold them, made into the closed surface of a solid.
#pragma once

#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::geometry {

/// Joins vertices at the same place, leaves out triangles that have lost a corner by that or are
/// there twice, and turns triangles so that neighbours wind the same way.
///
/// What is inside does not depend on how the triangles were turned before: each connected part is a
/// body, and bodies that overlap are one. A part that lies wholly within others is a body of its
/// own if these are even in number, and a cavity if they are odd. Bodies wind counter-clockwise
/// seen from outside, cavities the other way, so that a place is inside where the winding number is
/// above 0.
/// @throws MeshError when edges are open, when no way of turning the triangles fits, or when
/// nothing is enclosed
TriangleSurface closed_surface(const TriangleSurface& triangles);

/// How many of a closed surface's parts are cavities.
std::size_t inner_shells(const TriangleSurface& closed);

}  // namespace spindrift::geometry
