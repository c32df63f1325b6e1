// Points sorted by the cell of a uniform grid that they lie in. Only occupied cells are stored.
//
// A cell's key is x + nx (y + ny z): the three cells x−1, x, x+1 of a row are neighbours in key
// order, so the 27 cells around a cell are nine runs of consecutive points.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim/real.hpp"

namespace spindrift::sim {

/// Maps positions to cell keys. The grid covers a box with a margin, so that the neighbours of
/// every point's cell have valid keys.
struct GridMap {
  Vec3<float> origin{0, 0, 0};  ///< corner of cell (0, 0, 0), m
  float inverse_cell = 1;       ///< 1/m
  std::int64_t nx = 1, ny = 1, nz = 1;

  /// @param cell edge of a cell, m. @throws std::invalid_argument if the box has too many cells for
  /// a key.
  static GridMap over(Vec3<float> min, Vec3<float> max, float cell);

  std::uint64_t key(const Vec3<float>& p) const {
    return static_cast<std::uint64_t>(
        coordinate(p.x - origin.x, nx) +
        nx * (coordinate(p.y - origin.y, ny) + ny * coordinate(p.z - origin.z, nz)));
  }
  std::uint64_t key_count() const { return static_cast<std::uint64_t>(nx * ny * nz); }

 private:
  std::int64_t coordinate(float offset, std::int64_t n) const {
    const auto c = static_cast<std::int64_t>(offset * inverse_cell);
    return c < 1 ? 1 : (c > n - 2 ? n - 2 : c);
  }
};

/// Makes room for so many values; what they were is lost. Takes memory only where there is too
/// little, and then not twice as much, as vectors do.
template <class T>
void grow(std::vector<T>& values, std::size_t size) {
  if (size > values.capacity()) {
    values = {};
    values.reserve(size + size / 8);
  }
  values.resize(size);
}

/// The occupied cells of a sorted set of points.
class CellGrid {
 public:
  /// Sorts by cell; equal keys keep their order. Returns the permutation: new place k holds old
  /// point `order()[k]`.
  void sort(const GridMap& map, const Vec3Arrays& points, std::uint32_t count);

  const std::vector<std::uint32_t>& order() const { return order_; }
  /// Brings one number per point into the new order, once.
  void permute(std::vector<std::uint32_t>& values);
  /// Gives back the permutation's memory, where points stay as they are from now on.
  void forget_order();
  std::size_t cell_count() const { return cell_keys_.size(); }
  std::uint64_t cell_key(std::size_t c) const { return cell_keys_[c]; }
  /// First point of cell c; c may be cell_count(), then it is the number of points.
  std::uint32_t cell_begin(std::size_t c) const { return cell_begin_[c]; }
  /// Index of the first occupied cell whose key is not less than `key`.
  std::size_t first_cell_from(std::uint64_t key) const;
  std::size_t memory_bytes() const;

 private:
  template <class KeyOf>
  void find_cells(KeyOf key_of);

  std::vector<std::uint32_t> order_, scratch_;
  std::vector<std::uint64_t> cell_keys_;
  std::vector<std::uint32_t> cell_begin_;
};

/// Walks through the cells of one grid in the order of another's, and gives for each the nine runs
/// of points in the 27 cells around it. Since keys only grow, each of its 18 cursors only moves
/// forward.
class RowCursors {
 public:
  RowCursors(const GridMap& map, const CellGrid& grid) : map_(map), grid_(grid) {}

  /// The occupied cells of a row: keys from `low` to low + 2, indices from first to last − 1.
  struct Cells {
    std::uint64_t low;
    std::size_t first, last;
  };
  const std::array<Cells, 9>& cells_around(std::uint64_t key);

  struct Run {
    std::uint32_t begin, end;
  };
  const std::array<Run, 9>& around(std::uint64_t key);

 private:
  const GridMap& map_;
  const CellGrid& grid_;
  std::array<Cells, 9> cells_{};
  std::array<Run, 9> runs_{};
  bool started_ = false;
};

}  // namespace spindrift::sim
