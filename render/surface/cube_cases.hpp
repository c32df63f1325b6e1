// Tells which triangles the surface makes in a cube of the grid, for each of the 256 ways in which
// the cube's corners can lie inside or outside (Lorensen & Cline 1987, "Marching cubes").
//
// Corner c lies at x = c & 1, y = (c >> 1) & 1, z = c >> 2. Edge e = 4 axis + n starts at the n-th
// corner, in increasing order, whose coordinate along the axis is 0:
//
//          6 ------ 3 ------ 7          e   axis  corners
//         /|                /|          0   x     0-1
//       10 |              11 |          1   x     2-3
//       /  6              /  7          2   x     4-5
//      4 ------ 2 ------ 5   |          3   x     6-7
//      |   |             |   |          4   y     0-2
//      |   2 ------ 1 ---|-- 3          5   y     1-3
//      8  /              9  /           6   y     4-6     (in this picture x points right,
//      | 4               | 5            7   y     5-7      z up and y into the page)
//      |/                |/             8   z     0-4
//      0 ------ 0 ------ 1              9   z     1-5
//                                      10   z     2-6     (edges 10 and 11 run between 2-6 and 3-7)
//                                      11   z     3-7
#pragma once

#include <array>
#include <cstdint>

namespace spindrift::surface {

/// Where an edge of the cube lies.
struct CubeEdge {
  int axis;    ///< the edge is parallel to x (0), y (1) or z (2)
  int corner;  ///< corner at the lower end; that at the upper end is corner | 1 << axis
};

/// Returns where edge `edge`, 0 ... 11, lies.
constexpr CubeEdge cube_edge(int edge) {
  const int axis = edge / 4;
  const int n = edge % 4;
  const int below = n & ((1 << axis) - 1);  // n's bits for the axes below this one
  return {axis, below | ((n >> axis) << (axis + 1))};
}

/// The triangles of the surface in a cube.
struct CubeCase {
  static constexpr int max_triangles = 5;
  int triangle_count = 0;
  /// Cube edges that carry the triangles' corners, counter-clockwise seen from outside the liquid.
  std::array<std::array<std::uint8_t, 3>, max_triangles> triangles{};
};

/// Returns one case for each set of inside corners; bit c of the index is set if corner c is
/// inside.
///
/// On every face the surface separates the inside corners from each other, so that two cubes agree
/// about the face between them. No triangle's side joins two vertices of one face unless it is the
/// surface's own line on that face, so that no side is shared by more than two triangles. Together
/// that makes the whole mesh closed and manifold, whatever the field.
const std::array<CubeCase, 256>& cube_cases();

}  // namespace spindrift::surface
