// Triangles of a mesh with normals, to be drawn.
#pragma once

#include "sim/geometry/mesh/triangle_surface.hpp"
#include "sim/geometry/tessellation.hpp"

namespace spindrift::geometry {

/// A vertex gets as many normals as there are round surfaces that meet there: for each face the
/// mean of the faces around the vertex that are not at a sharp angle to it, weighted by their
/// angles (Thürmer & Wüthrich 1998).
void tessellate_smooth(Tessellation& into, const TriangleSurface& surface);

}  // namespace spindrift::geometry
