// Samples the liquid's smoothed indicator function (1 inside, 0 outside) on the nodes of a sparse
// grid.
//
// The grid is fixed in space: node (i, j, k) lies at (i, j, k) * cell size. Nodes are kept in
// blocks of 8 x 8 x 8 where particles reach; every other node is 0. A block that lies deep in the
// liquid is known to be inside and keeps no values. Node (x, y, z) of a block has the index
// x + 8 y + 64 z in it.
#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <memory>
#include <vector>

#include "render/surface/coverage.hpp"
#include "render/surface/particle_bins.hpp"

namespace spindrift::surface {

inline constexpr int block_edge = 8;  ///< nodes along the edge of a block
inline constexpr int block_nodes = block_edge * block_edge * block_edge;  ///< nodes of a block

/// On which side of the iso-value the nodes of a block lie.
enum class BlockSide : std::uint8_t { outside, inside, both };

/// The sampled field. Blocks are numbered by z, then y, then x.
class SparseField {
 public:
  /// Number of a block that is not kept, since the field is 0 at all of its nodes.
  static constexpr std::uint32_t no_block = ~std::uint32_t{0};

  /// Sums the kernels of all particles.
  /// @param cell_size distance between neighbouring nodes, in particle spacings
  /// @param iso_value value of the field that divides inside from outside
  SparseField(const ParticleBins& bins, const Coverage& coverage, double cell_size,
              float iso_value);

  std::size_t block_count() const { return keys_.size(); }
  double cell_size() const { return cell_size_; }

  /// Block coordinates of a block: its first node has 8 times these coordinates.
  glm::ivec3 cell(std::size_t block) const { return grid_cell(keys_[block]) + lower_; }
  /// Returns the number of the block at these block coordinates, or no_block.
  std::uint32_t find(const glm::ivec3& block_cell) const;

  BlockSide side(std::uint32_t block) const {
    return block == no_block ? BlockSide::outside : sides_[block];
  }

  /// Numbers of a block and its 26 neighbours, no_block for those not kept. The block itself is at
  /// index 13, the neighbour at the offset (x, y, z) from it at 13 + x + 3 y + 9 z.
  using Around = std::array<std::uint32_t, 27>;
  Around around(std::uint32_t block) const;

  /// Returns the field at the block_nodes nodes of a block, which may be no_block.
  const float* values(std::uint32_t block) const;
  float value(std::uint32_t block, int node) const { return values(block)[node]; }

  /// Returns the field at a point, by trilinear interpolation.
  /// @param near  a block and its neighbours; a point beyond them is found too, but more slowly
  /// @param point position relative to that block's first node, in cells
  float sample(const Around& near, const glm::vec3& point) const;

 private:
  void find_blocks(const ParticleBins& bins);
  void fill_blocks(const ParticleBins& bins, const Coverage& coverage, float iso_value);

  double cell_size_;
  glm::ivec3 lower_{0};              ///< smallest block coordinates, per axis
  std::vector<std::uint64_t> keys_;  ///< grid_key(block coordinates - lower_), ascending
  std::vector<BlockSide> sides_;
  /// Place of each block's values in values_, in blocks; no_block for a block deep inside, which is
  /// 1 at all of its nodes.
  std::vector<std::uint32_t> slots_;
  std::unique_ptr<float[]> values_;
};

}  // namespace spindrift::surface
