// Sorts points by the cells of a uniform grid, on the device.
#pragma once

#include "sim/backend/cells.hpp"
#include "sim/backend/device/arrays.hpp"

namespace spindrift::sim::inline device {

/// The occupied cells of a set of points, and the order that sorts the points by cell.
class CellGrid {
 public:
  /// Finds the order of the points by the keys of their cells; points with equal keys keep their
  /// order. The points themselves stay where they are: the one at k in the new order is order()[k].
  void sort(const GridMap& map, const PointView& points, std::uint32_t count);

  const Array<std::uint32_t>& order() const { return order_; }
  /// Brings an array with one number per point into the new order; to be called once per sort().
  void permute(Array<std::uint32_t>& values);
  /// Frees the memory of order(), where the points are not sorted again.
  void forget_order();
  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(cell_keys_.size()); }
  CellGridView view() const { return {cell_keys_.data(), cell_begins_.data(), cell_count()}; }
  std::size_t memory_bytes() const;

 private:
  Scratch scratch_;
  Array<std::uint32_t> order_, other_order_;
  Array<std::uint64_t> keys_, other_keys_;  ///< key of each point's cell
  Array<std::uint8_t> begins_cell_;         ///< whether each point is the first of its cell
  Array<std::uint64_t> cell_keys_;
  Array<std::uint32_t> cell_begins_;
};

}  // namespace spindrift::sim::inline device
