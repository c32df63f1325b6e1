// A sparse signed distance field of a closed surface: a grid that stores values near the surface
// only.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim/geometry/mesh/triangle_tree.hpp"

namespace spindrift::geometry {

/// Signed distances (m), negative inside, at the nodes of a cubic grid, with trilinear
/// interpolation in between. The grid is made of blocks; a block away from the surface stores only
/// on which side of it the block is.
class DistanceGrid {
 public:
  /// @param tree the triangles of the surface
  /// @param low, high corners of a box around the surface, m
  /// @param cell edge of the grid's cells, m
  /// @param depth down to which distances inside are right, m; a point that is deeper is only known
  /// to be deeper
  DistanceGrid(const TriangleTree& tree, const glm::vec3& low, const glm::vec3& high, float cell,
               float depth);

  using Value = DistanceGridView::Value;
  /// The signed distance and its gradient at a point, m.
  Value at(const glm::vec3& p) const { return view().at(p); }

  DistanceGridView view() const {
    return {origin_, cell_, counts_, blocks_.data(), values_.data()};
  }
  /// One entry per block, x fastest: its index among the stored blocks, or on which side it is.
  const std::vector<std::int32_t>& blocks() const { return blocks_; }
  /// The distances at the nodes of the stored blocks, block after block, x fastest, m.
  const std::vector<float>& values() const { return values_; }

 private:
  static constexpr int block_cells = DistanceGridView::block_cells;
  static constexpr int block_nodes = DistanceGridView::block_nodes;
  static constexpr std::int32_t outside = DistanceGridView::outside,
                                inside = DistanceGridView::inside;

  void sort_blocks(const TriangleTree& tree, std::size_t first, float depth);
  void fill_block(const TriangleTree& tree, std::size_t block, float depth);
  /// The lowest corner of a block, m.
  glm::vec3 corner(std::size_t block) const;

  glm::vec3 origin_;                  ///< lowest corner of the grid, m
  float cell_;                        ///< edge of a cell, m
  glm::ivec3 counts_;                 ///< blocks along each axis
  std::vector<std::int32_t> blocks_;  ///< index among the stored blocks, or `outside` or `inside`
  std::vector<float> values_;         ///< distances, block after block, x fastest, m
};

}  // namespace spindrift::geometry
