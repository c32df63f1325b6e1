// Distances from a closed surface on a grid that is there near the surface only.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim/geometry/mesh/triangle_tree.hpp"

namespace spindrift::geometry {

/// Signed distances, negative inside, at the nodes of a cubic grid, and linear in between. The grid
/// is made of blocks; those away from the surface know only on which side of it they are.
class DistanceGrid {
 public:
  /// @param low, high corners of a box around the surface, m
  /// @param cell the grid's cell, m
  /// @param depth down to which distances inside are right, m; deeper ones are only known to be
  /// deeper
  DistanceGrid(const TriangleTree& tree, const glm::vec3& low, const glm::vec3& high, float cell,
               float depth);

  using Value = DistanceGridView::Value;
  Value at(const glm::vec3& p) const { return view().at(p); }

  DistanceGridView view() const {
    return {origin_, cell_, counts_, blocks_.data(), values_.data()};
  }
  const std::vector<std::int32_t>& blocks() const { return blocks_; }
  const std::vector<float>& values() const { return values_; }

 private:
  static constexpr int block_cells = DistanceGridView::block_cells;
  static constexpr int block_nodes = DistanceGridView::block_nodes;
  static constexpr std::int32_t outside = DistanceGridView::outside,
                                inside = DistanceGridView::inside;

  void sort_blocks(const TriangleTree& tree, std::size_t first, float depth);
  void fill_block(const TriangleTree& tree, std::size_t block, float depth);
  glm::vec3 corner(std::size_t block) const;

  glm::vec3 origin_;
  float cell_;
  glm::ivec3 counts_;                 ///< blocks along each axis
  std::vector<std::int32_t> blocks_;  ///< number among the stored ones, or on which side it is
  std::vector<float> values_;         ///< block after block, x fastest, m
};

}  // namespace spindrift::geometry
