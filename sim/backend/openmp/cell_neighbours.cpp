#include "sim/backend/openmp/cell_neighbours.hpp"

#include <algorithm>

namespace spindrift::sim::inline openmp {

void CellNeighbours::build(const GridMap& map, const CellGridView& grid) {
  constexpr int rows = CellNeighbourView::rows;
  constexpr std::size_t cells_per_block = 512;
  const std::size_t cells = grid.cell_count;
  const std::size_t blocks = (cells + cells_per_block - 1) / cells_per_block;
  const std::size_t batches = (cells + lane_count - 1) / lane_count;
  grow(first_, batches * lane_count * rows);
  grow(occupied_, batches * lane_count);
#pragma omp parallel for schedule(dynamic, 1)
  for (std::size_t b = 0; b < blocks; ++b) {
    RowCursors cursors(map, grid);
    const std::size_t end = std::min(cells, (b + 1) * cells_per_block);
    for (auto cell = static_cast<std::uint32_t>(b * cells_per_block); cell < end; ++cell) {
      std::uint32_t occupied = 0;
      const auto& around = cursors.cells_around(grid.cell_key(cell));
      for (int r = 0; r < rows; ++r) {
        const auto& [low, first, last] = around[static_cast<std::size_t>(r)];
        for (std::uint32_t other = first; other < last; ++other)
          occupied |= 1u << (3 * r + static_cast<int>(grid.cell_key(other) - low));
        first_[CellNeighbourView::row_place(cell, r)] =
            static_cast<std::uint32_t>(first < last ? first : cell);
      }
      occupied_[cell] = occupied;
    }
  }
  for (std::size_t c = cells; c < batches * lane_count; ++c) {
    occupied_[c] = 0;
    for (int r = 0; r < rows; ++r)
      first_[CellNeighbourView::row_place(static_cast<std::uint32_t>(c), r)] = 0;
  }
}

}  // namespace spindrift::sim::inline openmp
