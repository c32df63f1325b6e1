// Which of the 26 cells around an occupied cell are occupied, and where they stand in the grid: for
// each of the nine rows the first occupied cell of the three, and a bit for each.
#pragma once

#include "sim/backend/cells.hpp"
#include "sim/backend/device/arrays.hpp"

namespace spindrift::sim::inline device {

struct CellNeighbourView {
  const std::uint32_t* first = nullptr;     ///< row by row, one per cell
  const std::uint32_t* occupied = nullptr;  ///< a bit for each slot
  std::uint32_t cell_count = 0;
  static constexpr int slots = 27;  ///< cells around a cell, x fastest; itself in the middle
  static constexpr int self = 13;

  /// Index of the cell in a slot; −1: it is not occupied.
  SPINDRIFT_HD std::int32_t at(std::uint32_t cell, int slot) const {
    const std::uint32_t row = occupied[cell] >> (slot / 3 * 3) & 7u, place = slot % 3;
    if ((row >> place & 1) == 0)
      return -1;
    const std::uint32_t before =
        place == 0 ? 0 : (place == 1 ? row & 1 : (row & 1) + (row >> 1 & 1));
    return static_cast<std::int32_t>(first[std::size_t{cell_count} * (slot / 3) + cell] + before);
  }

  /// Where a number of each cell and slot stands.
  SPINDRIFT_HD static std::size_t place(std::uint32_t cell, int slot) {
    return (std::size_t{cell / lane_count} * slots + slot) * lane_count + cell % lane_count;
  }

  /// A cell's own weight times its value, less those of the cells around it.
  SPINDRIFT_HD void apply(std::uint32_t cell, const float* weights, const float* values,
                          float* image) const {
    float sum = weights[place(cell, self)] * values[cell];
    for (int slot = 0; slot < slots; ++slot) {
      const std::int32_t other = slot == self ? -1 : at(cell, slot);
      if (other >= 0)
        sum -= weights[place(cell, slot)] * values[other];
    }
    image[cell] = sum;
  }
};

class CellNeighbours {
 public:
  void build(const GridMap& map, const CellGridView& grid);
  CellNeighbourView view() const {
    return {first_.data(), occupied_.data(), static_cast<std::uint32_t>(occupied_.size())};
  }
  std::size_t memory_bytes() const { return (first_.capacity() + occupied_.capacity()) * 4; }

 private:
  Array<std::uint32_t> first_, occupied_;
};

}  // namespace spindrift::sim::inline device
