// Finds which closed parts of a surface are cavities, by how many others each lies within.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::geometry {

/// A connected, closed part of a surface.
struct Shell {
  std::vector<std::uint32_t> triangles;  ///< indices into the surface's triangles
  double volume;                         ///< enclosed volume, m³
};

/// The indices of the shells that lie wholly within an odd number of others. A shell lies within
/// another if none of its corners, nor the middle of any of its triangles, is outside the other.
/// @param surface the triangles of all shells, facing out of each
/// @throws MeshError if so many shells lie within others that the search would take minutes
std::vector<std::size_t> cavities_among(const TriangleSurface& surface,
                                        const std::vector<Shell>& shells);

}  // namespace spindrift::geometry
