// Even layers of samples below a surface of triangles, where boundary particles are placed.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim/geometry/mesh/triangle_tree.hpp"
#include "sim/geometry/surface_sample.hpp"

namespace spindrift::geometry {

/// Samples half a spacing (m) below a closed surface, about one per spacing². Walls thinner than
/// 1.25 spacings have one denser layer, in their middle. The same input gives the same samples.
/// @param tree the triangles of `surface`
std::vector<SurfaceSample> sample_mesh(const TriangleSurface& surface, const TriangleTree& tree,
                                       float spacing);

}  // namespace spindrift::geometry
