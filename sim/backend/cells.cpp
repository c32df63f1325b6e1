#include "sim/backend/cells.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace spindrift::sim {

GridMap GridMap::over(Vec3<float> min, Vec3<float> max, float cell) {
  const auto cells = [&](float lo, float hi) {
    return static_cast<double>(std::ceil((static_cast<double>(hi) - lo) / cell)) + 4;
  };
  const double nx = cells(min.x, max.x), ny = cells(min.y, max.y), nz = cells(min.z, max.z);
  if (!(nx * ny * nz < 9e18 && nx < 1e7 && ny < 1e7 && nz < 1e7))
    throw std::invalid_argument(
        "the domain is more than ten million support radii wide; "
        "use a larger fluid.spacing or a smaller domain");
  GridMap map;
  map.origin = {min.x - 2 * cell, min.y - 2 * cell, min.z - 2 * cell};
  map.inverse_cell = 1 / cell;
  map.nx = static_cast<std::int64_t>(nx);
  map.ny = static_cast<std::int64_t>(ny);
  map.nz = static_cast<std::int64_t>(nz);
  return map;
}

const std::array<RowCursors::Cells, 9>& RowCursors::cells_around(std::uint64_t key) {
  const std::uint32_t n = grid_.cell_count;
  for (int row = 0; row < 9; ++row) {
    auto& [low, first, last] = cells_[static_cast<std::size_t>(row)];
    low = map_.row_key(key, row);
    if (!started_)
      first = last = grid_.first_cell_from(low);
    while (first < n && grid_.keys[first] < low)
      ++first;
    last = std::max(first, last);
    while (last < n && grid_.keys[last] <= low + 2)
      ++last;
  }
  started_ = true;
  return cells_;
}

const std::array<RowCursors::Run, 9>& RowCursors::around(std::uint64_t key) {
  cells_around(key);
  for (std::size_t row = 0; row < runs_.size(); ++row)
    runs_[row] = {grid_.cell_begin(cells_[row].first), grid_.cell_begin(cells_[row].last)};
  return runs_;
}

}  // namespace spindrift::sim
