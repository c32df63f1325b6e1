// Which of the 26 cells around an occupied cell are occupied, and where they stand in the grid.
//
// The three cells x−1, x, x+1 of a row follow each other in the grid's order, as far as they are
// occupied. So the first one's index is kept for each of the nine rows, and a bit for each cell.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/backend/openmp/cell_grid.hpp"
#include "sim/core/real.hpp"

namespace spindrift::sim::inline openmp {

struct CellNeighbourView {
  const std::uint32_t* first = nullptr;     ///< nine per cell: of the row's first occupied cell
  const std::uint32_t* occupied = nullptr;  ///< a bit for each slot
  static constexpr int slots = 27;  ///< cells around a cell, x fastest; itself in the middle
  static constexpr int self = 13;
  static constexpr int rows = 9;

  /// Index of the cell in a slot; −1: it is not occupied.
  std::int32_t at(std::uint32_t cell, int slot) const {
    const std::uint32_t row = occupied[cell] >> (slot / 3 * 3) & 7u, place = slot % 3;
    if ((row >> place & 1) == 0)
      return -1;
    const std::uint32_t before =
        place == 0 ? 0 : (place == 1 ? row & 1 : (row & 1) + (row >> 1 & 1));
    return static_cast<std::int32_t>(first[row_place(cell, slot / 3)] + before);
  }

  /// Of eight cells, from `cell` on, a multiple of eight: the indices of the cells x−1, x, x+1 in a
  /// row. Where one is not occupied it is any index up to one beyond the last cell.
  std::array<IndexLanes, 3> row(std::uint32_t cell, int row) const {
    IndexLanes begin, bits;
    __builtin_memcpy(&begin, &first[row_place(cell, row)], sizeof begin);
    __builtin_memcpy(&bits, &occupied[cell], sizeof bits);
    const IndexLanes second = begin + (bits >> (3 * row) & 1);
    return {begin, second, second + (bits >> (3 * row + 1) & 1)};
  }

  /// A cell's own weight times its value, less those of the cells around it; of eight cells at
  /// once, those from each that is a multiple of eight on.
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

  /// Where a number of each cell and slot stands: eight cells' beside each other.
  static std::size_t place(std::uint32_t cell, int slot) {
    return (std::size_t{cell / lane_count} * slots + slot) * lane_count + cell % lane_count;
  }
  static std::size_t row_place(std::uint32_t cell, int row) {
    return (std::size_t{cell / lane_count} * rows + row) * lane_count + cell % lane_count;
  }
};

class CellNeighbours {
 public:
  void build(const GridMap& map, const CellGridView& grid);
  CellNeighbourView view() const { return {first_.data(), occupied_.data()}; }
  std::size_t memory_bytes() const { return (first_.capacity() + occupied_.capacity()) * 4; }

 private:
  std::vector<std::uint32_t> first_, occupied_;
};

}  // namespace spindrift::sim::inline openmp
