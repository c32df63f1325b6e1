// Triangulation of the polygons of mesh files.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace spindrift::geometry {

/// The largest accepted number of corners of a polygon that is not convex: the time to cut it grows
/// with the square of their number.
inline constexpr std::size_t most_corners = 1000;

/// Cuts a polygon into triangles that wind as it does and appends them to `into`; a polygon of
/// fewer than three corners gives none. A convex polygon becomes a fan around its first corner;
/// from others ears are clipped (Meisters 1975, "Polygons have ears"), seen along the polygon's
/// mean normal. A polygon that crosses itself, or has no area, is cut in an unspecified way that
/// keeps its edges.
/// @param corners valid indices into `vertices`
/// @throws MeshError for a polygon that is not convex and has too many corners
void cut_polygon(const std::vector<glm::vec3>& vertices, std::span<const std::uint32_t> corners,
                 std::vector<glm::uvec3>& into);

}  // namespace spindrift::geometry
