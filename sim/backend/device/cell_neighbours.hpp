// The occupied cells among the 27 around each occupied cell, for the coarse pressure grid. For each
// cell and each of the nine rows around it the index of the row's first occupied cell is kept, and
// for each of the 27 cells a bit that says whether it is occupied.
#pragma once

#include "sim/backend/cells.hpp"
#include "sim/backend/device/arrays.hpp"

namespace spindrift::sim::inline device {

/// The neighbours of every cell, as loops see them. The 27 cells around a cell are its slots.
struct CellNeighbourView {
  const std::uint32_t* first = nullptr;     ///< first occupied cell, row by row, one per cell
  const std::uint32_t* occupied = nullptr;  ///< one bit per slot, for each cell
  std::uint32_t cell_count = 0;
  static constexpr int slots = 27;  ///< number of slots, in the order x fastest
  static constexpr int self = 13;   ///< slot of the cell itself

  /// Index of the cell in a slot; −1 if that is not occupied.
  SPINDRIFT_HD std::int32_t at(std::uint32_t cell, int slot) const {
    const std::uint32_t row = occupied[cell] >> (slot / 3 * 3) & 7u, place = slot % 3;
    if ((row >> place & 1) == 0)
      return -1;
    const std::uint32_t before =
        place == 0 ? 0 : (place == 1 ? row & 1 : (row & 1) + (row >> 1 & 1));
    return static_cast<std::int32_t>(first[std::size_t{cell_count} * (slot / 3) + cell] + before);
  }

  /// Index, in an array with one number per cell and slot, of the number of a cell and slot.
  SPINDRIFT_HD static std::size_t place(std::uint32_t cell, int slot) {
    return (std::size_t{cell / lane_count} * slots + slot) * lane_count + cell % lane_count;
  }

  /// Writes to image[cell] the cell's own weight times its value, less those of the cells around
  /// it.
  /// @param weights one per cell and slot, at place()
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

/// Finds and holds the neighbours of every cell of a grid.
class CellNeighbours {
 public:
  void build(const GridMap& map, const CellGridView& grid);
  CellNeighbourView view() const {
    return {first_.data(), occupied_.data(), static_cast<std::uint32_t>(occupied_.size())};
  }
  std::size_t memory_bytes() const { return bytes_of(first_, occupied_); }

 private:
  Array<std::uint32_t> first_, occupied_;
};

}  // namespace spindrift::sim::inline device
