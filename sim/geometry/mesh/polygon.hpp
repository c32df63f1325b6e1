// Polygons of mesh files, cut into triangles.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace spindrift::geometry {

/// Most corners of a polygon that is not convex: cutting those takes time that grows with the
/// square of their number.
inline constexpr std::size_t most_corners = 1000;

/// Cuts a polygon into triangles that wind as it does and appends them; nothing for fewer than
/// three corners. A convex polygon becomes a fan around its first corner; from others ears are
/// clipped (Meisters 1975, "Polygons have ears"), seen along the polygon's mean normal. One that
/// crosses itself, or encloses nothing, is cut somehow, and its edges are kept.
/// @param corners places in `vertices`, all of them there
/// @throws MeshError for a polygon that is not convex and has too many corners
void cut_polygon(const std::vector<glm::vec3>& vertices, std::span<const std::uint32_t> corners,
                 std::vector<glm::uvec3>& into);

}  // namespace spindrift::geometry
