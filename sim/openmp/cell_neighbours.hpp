// Which of the 26 cells around an occupied cell are occupied, and where they stand in the grid.
//
// The three cells x−1, x, x+1 of a row follow each other in the grid's order, as far as they are
// occupied. So the first one's index is kept for each of the nine rows, and a bit for each cell.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/openmp/cell_grid.hpp"
#include "sim/real.hpp"

namespace spindrift::sim {

class CellNeighbours {
 public:
  static constexpr int slots = 27;  ///< cells around a cell, x fastest; itself in the middle
  static constexpr int self = 13;

  void build(const GridMap& map, const CellGrid& grid);

  /// Index of the cell in a slot; −1: it is not occupied.
  std::int32_t at(std::uint32_t cell, int slot) const {
    const std::uint32_t row = occupied_[cell] >> (slot / 3 * 3) & 7u, place = slot % 3;
    if ((row >> place & 1) == 0)
      return -1;
    const std::uint32_t before =
        place == 0 ? 0 : (place == 1 ? row & 1 : (row & 1) + (row >> 1 & 1));
    return static_cast<std::int32_t>(first_[first_place(cell, slot / 3)] + before);
  }

  /// Of eight cells, from `cell` on, a multiple of eight: the indices of the cells x−1, x, x+1 in a
  /// row. Where one is not occupied it is any index up to one beyond the last cell.
  std::array<IndexLanes, 3> row(std::uint32_t cell, int row) const {
    IndexLanes first, bits;
    __builtin_memcpy(&first, &first_[first_place(cell, row)], sizeof first);
    __builtin_memcpy(&bits, &occupied_[cell], sizeof bits);
    const IndexLanes second = first + (bits >> (3 * row) & 1);
    return {first, second, second + (bits >> (3 * row + 1) & 1)};
  }

  std::size_t memory_bytes() const { return (first_.capacity() + occupied_.capacity()) * 4; }

 private:
  static constexpr int rows = 9;
  /// Eight cells' numbers stand beside each other.
  static std::size_t first_place(std::uint32_t cell, int row) {
    return (std::size_t{cell / lane_count} * rows + row) * lane_count + cell % lane_count;
  }

  std::vector<std::uint32_t> first_;     ///< nine per cell: of the row's first occupied cell
  std::vector<std::uint32_t> occupied_;  ///< a bit for each slot
};

}  // namespace spindrift::sim
