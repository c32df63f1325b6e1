#include "sim/backend/device/cell_neighbours.hpp"

#include "sim/backend/device/loops.hpp"

namespace spindrift::sim::inline device {

void CellNeighbours::build(const GridMap& map, const CellGridView& grid) {
  const std::uint32_t cells = grid.cell_count;
  first_.renew(std::size_t{cells} * 9);
  occupied_.renew(cells);
  std::uint32_t *first = first_.data(), *occupied = occupied_.data();
  launch(cells, [=] SPINDRIFT_HD(std::uint32_t c) {
    std::uint32_t bits = 0;
    for (int row = 0; row < 9; ++row) {
      const std::uint64_t low = map.row_key(grid.cell_key(c), row);
      const std::uint32_t begin = grid.first_cell_from(low);
      first[std::size_t{cells} * row + c] = begin;
      for (std::uint32_t other = begin; other < cells && grid.cell_key(other) <= low + 2; ++other)
        bits |= 1u << (3 * row + static_cast<int>(grid.cell_key(other) - low));
    }
    occupied[c] = bits;
  });
}

}  // namespace spindrift::sim::inline device
