// Even layers of points below a surface of triangles.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim/geometry/mesh/triangle_tree.hpp"
#include "sim/geometry/surface_sample.hpp"

namespace spindrift::geometry {

/// Samples half a spacing below the surface, about one per spacing², the same ones every time.
/// Walls thinner than 1.25 spacings have one layer, in their middle, which is closer.
std::vector<SurfaceSample> sample_mesh(const TriangleSurface& surface, const TriangleTree& tree,
                                       float spacing);

}  // namespace spindrift::geometry
