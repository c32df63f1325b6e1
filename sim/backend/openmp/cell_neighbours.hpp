// The occupied cells among the 27 around each occupied cell, for the coarse pressure grid.
//
// Those of the three cells x−1, x, x+1 of a row that are occupied follow each other in the grid's
// order. So for each cell and each of the nine rows around it the index of the row's first occupied
// cell is kept, and for each of the 27 cells a bit that says whether it is occupied.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/backend/openmp/cell_grid.hpp"
#include "sim/core/real.hpp"

namespace spindrift::sim::inline openmp {

/// The neighbours of every cell, as loops see them. The 27 cells around a cell are its slots.
struct CellNeighbourView {
  const std::uint32_t* first = nullptr;  ///< first occupied cell, per cell and row, at row_place()
  const std::uint32_t* occupied = nullptr;  ///< one bit per slot, for each cell
  static constexpr int slots = 27;          ///< number of slots, in the order x fastest
  static constexpr int self = 13;           ///< slot of the cell itself
  static constexpr int rows = 9;

  /// Index of the cell in a slot; −1 if that is not occupied.
  std::int32_t at(std::uint32_t cell, int slot) const {
    const std::uint32_t row = occupied[cell] >> (slot / 3 * 3) & 7u, place = slot % 3;
    if ((row >> place & 1) == 0)
      return -1;
    const std::uint32_t before =
        place == 0 ? 0 : (place == 1 ? row & 1 : (row & 1) + (row >> 1 & 1));
    return static_cast<std::int32_t>(first[row_place(cell, slot / 3)] + before);
  }

  /// The indices of the cells x−1, x, x+1 in a row around each of eight cells, from `cell` on. For
  /// one that is not occupied it is any index up to one beyond the last cell.
  /// @param cell a multiple of eight
  std::array<IndexLanes, 3> row(std::uint32_t cell, int row) const {
    IndexLanes begin, bits;
    __builtin_memcpy(&begin, &first[row_place(cell, row)], sizeof begin);
    __builtin_memcpy(&bits, &occupied[cell], sizeof bits);
    const IndexLanes second = begin + (bits >> (3 * row) & 1);
    return {begin, second, second + (bits >> (3 * row + 1) & 1)};
  }

  /// Writes to image[cell] the cell's own weight times its value, less those of the cells around
  /// it. A call for a multiple of eight does so for the eight cells from there on; others do
  /// nothing.
  /// @param weights one per cell and slot, at place()
  void apply(std::uint32_t cell, const float* weights, const float* values, float* image) const {
    if (cell % lane_count != 0)
      return;
    const float* w = &weights[place(cell, 0)];
    const auto weight = [&](int slot) { return consecutive(w + slot * lane_count); };
    Lanes sum = weight(self) * consecutive(values + cell);
    for (int r = 0; r < rows; ++r) {
      const auto other = row(cell, r);
      for (int k = 0; k < 3; ++k)
        if (3 * r + k != self)
          sum -= weight(3 * r + k) * load(values, other[static_cast<std::size_t>(k)]);
    }
    __builtin_memcpy(image + cell, &sum, sizeof sum);
  }

  /// Index, in an array with one number per cell and slot, of the number of a cell and slot. The
  /// numbers of eight cells stand beside each other.
  static std::size_t place(std::uint32_t cell, int slot) {
    return (std::size_t{cell / lane_count} * slots + slot) * lane_count + cell % lane_count;
  }
  /// The same for an array with one number per cell and row.
  static std::size_t row_place(std::uint32_t cell, int row) {
    return (std::size_t{cell / lane_count} * rows + row) * lane_count + cell % lane_count;
  }
};

/// Finds and holds the neighbours of every cell of a grid.
class CellNeighbours {
 public:
  void build(const GridMap& map, const CellGridView& grid);
  CellNeighbourView view() const { return {first_.data(), occupied_.data()}; }
  std::size_t memory_bytes() const { return bytes_of(first_, occupied_); }

 private:
  std::vector<std::uint32_t> first_, occupied_;
};

}  // namespace spindrift::sim::inline openmp
