// The liquid's smoothed indicator (1 inside, 0 outside) on the nodes of a sparse grid.
//
// The grid is fixed in space: node (i, j, k) lies at (i, j, k) * cell size. Nodes are kept in
// blocks of 8 x 8 x 8 where particles reach; every other node is 0. A block that lies deep in the
// liquid is known to be inside and keeps no values. Node index within a block: x + 8 y + 64 z.
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
inline constexpr int block_nodes = block_edge * block_edge * block_edge;

/// On which side of the iso-value the nodes of a block lie.
enum class BlockSide : std::uint8_t { outside, inside, both };

class SparseField {
 public:
  static constexpr std::uint32_t no_block = ~std::uint32_t{0};

  /// @param cell_size in spacings
  SparseField(const ParticleBins& bins, const Coverage& coverage, double cell_size,
              float iso_value);

  std::size_t block_count() const { return keys_.size(); }
  double cell_size() const { return cell_size_; }

  /// Block coordinates: the block's first node is 8 times this.
  glm::ivec3 cell(std::size_t block) const { return grid_cell(keys_[block]) + lower_; }
  /// The block at these block coordinates, or no_block.
  std::uint32_t find(const glm::ivec3& block_cell) const;

  BlockSide side(std::uint32_t block) const {
    return block == no_block ? BlockSide::outside : sides_[block];
  }

  /// A block and its 26 neighbours, or no_block: x + 3 y + 9 z, the block itself at 13.
  using Around = std::array<std::uint32_t, 27>;
  Around around(std::uint32_t block) const;

  /// Field at the nodes of a block, which may be no_block.
  const float* values(std::uint32_t block) const;
  float value(std::uint32_t block, int node) const { return values(block)[node]; }

  /// Field at a point, by trilinear interpolation.
  /// @param near  a block and its neighbours; the point is thought to lie among them
  /// @param point relative to that block's first node, in cells
  float sample(const Around& near, const glm::vec3& point) const;

 private:
  void find_blocks(const ParticleBins& bins);
  void fill_blocks(const ParticleBins& bins, const Coverage& coverage, float iso_value);

  double cell_size_;
  glm::ivec3 lower_{0};
  std::vector<std::uint64_t> keys_;
  std::vector<BlockSide> sides_;
  std::vector<std::uint32_t> slots_;  ///< where a block's values are; no_block: deep inside, all 1
  std::unique_ptr<float[]> values_;
};

}  // namespace spindrift::surface
