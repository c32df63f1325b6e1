// Which parts of a surface lie within others.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::geometry {

/// A closed part of a surface.
struct Shell {
  std::vector<std::uint32_t> triangles;  ///< numbers in the surface
  double volume;                         ///< within it, m³
};

/// The shells that lie wholly within an odd number of others, by their numbers. One lies within
/// another where none of its corners, nor the middle of any of its triangles, is outside that.
/// @param surface whose triangles face out of each shell
/// @throws MeshError where so many lie within others that telling would take minutes
std::vector<std::size_t> cavities_among(const TriangleSurface& surface,
                                        const std::vector<Shell>& shells);

}  // namespace spindrift::geometry
