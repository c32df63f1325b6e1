// Sorts points by the cells of a uniform grid, on the CPU's cores.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/backend/cells.hpp"
#include "sim/backend/openmp/arrays.hpp"

namespace spindrift::sim::inline openmp {

/// The occupied cells of a set of points, and the order that sorts the points by cell.
class CellGrid {
 public:
  /// Finds the order of the points by the keys of their cells; points with equal keys keep their
  /// order. The points themselves stay where they are: the one at k in the new order is order()[k].
  void sort(const GridMap& map, const PointView& points, std::uint32_t count);

  const std::vector<std::uint32_t>& order() const { return order_; }
  /// Brings an array with one number per point into the new order; to be called once per sort().
  void permute(std::vector<std::uint32_t>& values);
  /// Frees the memory of order(), where the points are not sorted again.
  void forget_order();
  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(cell_keys_.size()); }
  CellGridView view() const { return {cell_keys_.data(), cell_begin_.data(), cell_count()}; }
  std::uint64_t cell_key(std::uint32_t c) const { return cell_keys_[c]; }
  /// Index of the first point of cell c; for c = cell_count() the number of points.
  std::uint32_t cell_begin(std::uint32_t c) const { return cell_begin_[c]; }
  std::size_t memory_bytes() const;

 private:
  template <class KeyOf>
  void find_cells(KeyOf key_of);

  std::vector<std::uint32_t> order_, scratch_;
  std::vector<std::uint64_t> cell_keys_;
  std::vector<std::uint32_t> cell_begin_;
};

}  // namespace spindrift::sim::inline openmp
