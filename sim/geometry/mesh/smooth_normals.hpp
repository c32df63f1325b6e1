// Vertex normals of a mesh, with which the renderer draws it smooth but for its sharp edges.
#pragma once

#include "sim/geometry/mesh/triangle_surface.hpp"
#include "sim/geometry/tessellation.hpp"

namespace spindrift::geometry {

/// Appends the triangles of a surface with vertex normals. At each vertex the normal of a face is
/// the mean over the faces around the vertex that are not at a sharp angle to it, weighted by their
/// angles there (Thürmer & Wüthrich 1998); a vertex is repeated for each different normal.
void tessellate_smooth(Tessellation& into, const TriangleSurface& surface);

}  // namespace spindrift::geometry
