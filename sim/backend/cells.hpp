// Points sorted by the cells of a uniform grid, for the neighbour search of both backends. Only
// occupied cells are stored.
//
// A cell's key is x + nx (y + ny z). The three cells x−1, x, x+1 of a row are neighbours in key
// order, so that the points of the 27 cells around a cell are nine runs of consecutive points.
#pragma once

#include <array>
#include <cstdint>

#include "sim/core/real.hpp"

namespace spindrift::sim {

/// Maps positions to cell keys. The grid covers a box with a margin, so that the neighbours of
/// every point's cell have valid keys.
struct GridMap {
  Vec3<float> origin{0, 0, 0};          ///< corner of cell (0, 0, 0), m
  float inverse_cell = 1;               ///< 1/m
  std::int64_t nx = 1, ny = 1, nz = 1;  ///< number of cells along each axis

  /// The map of a grid over the box from `min` to `max`, m, and its margin.
  /// @param cell edge of a cell, m
  /// @throws std::invalid_argument if the box has too many cells for a key
  static GridMap over(Vec3<float> min, Vec3<float> max, float cell);

  /// Key of the cell that holds p, m, or of the nearest one that has neighbours on all sides.
  SPINDRIFT_HD std::uint64_t key(const Vec3<float>& p) const {
    return static_cast<std::uint64_t>(
        coordinate(p.x - origin.x, nx) +
        nx * (coordinate(p.y - origin.y, ny) + ny * coordinate(p.z - origin.z, nz)));
  }
  /// Key of the first of the three cells in one of the nine rows around a cell.
  /// @param row 0 to 8, y fastest
  SPINDRIFT_HD std::uint64_t row_key(std::uint64_t cell_key, int row) const {
    return static_cast<std::uint64_t>(static_cast<std::int64_t>(cell_key) +
                                      nx * ((row % 3 - 1) + ny * (row / 3 - 1)) - 1);
  }
  /// Number of all cells; keys are below it.
  std::uint64_t key_count() const { return static_cast<std::uint64_t>(nx * ny * nz); }

 private:
  SPINDRIFT_HD std::int64_t coordinate(float offset, std::int64_t n) const {
    const auto c = static_cast<std::int64_t>(offset * inverse_cell);
    return c < 1 ? 1 : (c > n - 2 ? n - 2 : c);
  }
};

/// The occupied cells of a sorted set of points, in the order of their keys.
struct CellGridView {
  const std::uint64_t* keys = nullptr;
  const std::uint32_t* begins = nullptr;  ///< first point of each cell, then the number of points
  std::uint32_t cell_count = 0;

  SPINDRIFT_HD std::uint64_t cell_key(std::uint32_t c) const { return keys[c]; }
  /// Index of the first point of cell c; for c = cell_count the number of points.
  SPINDRIFT_HD std::uint32_t cell_begin(std::uint32_t c) const { return begins[c]; }

  /// Index of the first occupied cell whose key is not less than `key`, or cell_count.
  SPINDRIFT_HD std::uint32_t first_cell_from(std::uint64_t key) const {
    std::uint32_t first = 0;
    for (std::uint32_t left = cell_count; left > 0;) {
      const std::uint32_t half = left / 2;
      if (keys[first + half] < key) {
        first += half + 1;
        left -= half + 1;
      } else {
        left = half;
      }
    }
    return first;
  }
};

/// Finds the nine runs of points in the 27 cells around each of a series of cells, whose keys must
/// ascend. Since they do, each of its 18 cursors only moves forward.
class RowCursors {
 public:
  /// @param grid the grid whose points are found
  RowCursors(const GridMap& map, const CellGridView& grid) : map_(map), grid_(grid) {}

  /// The occupied cells of a row: keys from `low` to low + 2, indices in [first, last).
  struct Cells {
    std::uint64_t low;
    std::uint32_t first, last;
  };
  /// The occupied cells in the nine rows around the cell with this key.
  const std::array<Cells, 9>& cells_around(std::uint64_t key);

  /// Points with indices in [begin, end).
  struct Run {
    std::uint32_t begin, end;
  };
  /// The points in the nine rows around the cell with this key.
  const std::array<Run, 9>& around(std::uint64_t key);

 private:
  const GridMap& map_;
  CellGridView grid_;
  std::array<Cells, 9> cells_{};
  std::array<Run, 9> runs_{};
  bool started_ = false;
};

}  // namespace spindrift::sim
