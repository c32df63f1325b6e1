#include "sim/geometry/mesh/distance_grid.hpp"

#include <cmath>

namespace spindrift::geometry {
namespace {

/// The fraction by which a distance on the grid may be too large.
constexpr float tolerance = 0.05f;

}  // namespace

DistanceGrid::DistanceGrid(const TriangleTree& tree, const glm::vec3& low, const glm::vec3& high,
                           float cell, float depth)
    : origin_(low - cell), cell_(cell) {
  const float edge = static_cast<float>(block_cells) * cell;
  counts_ = glm::ivec3(glm::ceil((high + cell - origin_) / edge));
  blocks_.resize(std::size_t(counts_.x) * counts_.y * counts_.z);
  const int rows = counts_.y * counts_.z;
#pragma omp parallel for schedule(dynamic, 1)
  for (int row = 0; row < rows; ++row)
    sort_blocks(tree, std::size_t(row) * counts_.x, depth);
  std::vector<std::size_t> stored;
  for (std::size_t block = 0; block < blocks_.size(); ++block)
    if (blocks_[block] == 0) {
      blocks_[block] = static_cast<std::int32_t>(stored.size());
      stored.push_back(block);
    }
  values_.resize(stored.size() * block_nodes * block_nodes * block_nodes);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t k = 0; k < stored.size(); ++k)
    fill_block(tree, stored[k], depth);
}

glm::vec3 DistanceGrid::corner(std::size_t block) const {
  const auto b = static_cast<int>(block);
  const glm::ivec3 place(b % counts_.x, b / counts_.x % counts_.y, b / counts_.x / counts_.y);
  return origin_ + cell_ * glm::vec3(block_cells * place);
}

/// Classifies a row of blocks: a block through which the surface may pass, to which it may come
/// nearer than a cell, or which is just below it becomes 0; any other becomes `inside` or
/// `outside`.
void DistanceGrid::sort_blocks(const TriangleTree& tree, std::size_t first, float depth) {
  const float edge = static_cast<float>(block_cells) * cell_;
  const float half_diagonal = 0.5f * std::sqrt(3.f) * edge;
  const float wanted[] = {half_diagonal + cell_, half_diagonal + depth};  // outside, inside
  float distance = 0;
  bool below = false;
  for (std::size_t block = first; block < first + counts_.x; ++block) {
    distance -= 1.001f * edge;  // a lower bound, from that of the last block's centre
    if (distance <= wanted[below]) {
      const glm::vec3 center = corner(block) + 0.5f * edge;
      distance = tree.nearest(center).distance;
      below = tree.winding_number(center) > 0;
    }
    blocks_[block] = distance <= wanted[below] ? 0 : below ? inside : outside;
  }
}

/// Visits the nodes of a block one after the other, each a cell from the last one within a row.
/// From point to point the distance changes by no more than the way between them, which spares most
/// of the work: a node that is nearer to the last one than that one was to the surface is on the
/// same side of it; and a lower bound is enough two cells (a cell's diagonal and a margin) away
/// from where the distance is of use.
void DistanceGrid::fill_block(const TriangleTree& tree, std::size_t block, float depth) {
  const glm::vec3 low = corner(block);
  float* value =
      values_.data() + std::size_t(blocks_[block]) * block_nodes * block_nodes * block_nodes;
  glm::vec3 last(0);
  float last_distance = 0, side = 1;  // of the last node whose distance was looked up
  std::uint32_t guess = 0;
  for (int k = 0; k < block_nodes; ++k)
    for (int j = 0; j < block_nodes; ++j)
      for (int i = 0; i < block_nodes; ++i, ++value) {
        const glm::vec3 p = low + cell_ * glm::vec3(i, j, k);
        const float at_least = (1 - tolerance) * last_distance - 1.001f * glm::length(p - last);
        if (at_least > (side > 0 ? 0 : depth) + 2 * cell_) {
          *value = side * at_least;
          continue;
        }
        const TriangleTree::Nearest nearest = tree.nearest(p, guess, tolerance);
        if (at_least <= 0)
          side = tree.winding_number(p) > 0 ? -1.f : 1.f;
        last = p;
        last_distance = nearest.distance;
        guess = nearest.triangle;
        *value = side * nearest.distance;
      }
}

}  // namespace spindrift::geometry
