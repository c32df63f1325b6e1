// Sorts points by cell on the device.
#pragma once

#include "sim/backend/cells.hpp"
#include "sim/backend/device/arrays.hpp"

namespace spindrift::sim::inline device {

/// The occupied cells of a sorted set of points.
class CellGrid {
 public:
  /// Sorts by cell; equal keys keep their order. The permutation: new place k holds old point
  /// `order()[k]`.
  void sort(const GridMap& map, const PointView& points, std::uint32_t count);

  const Array<std::uint32_t>& order() const { return order_; }
  /// Brings one number per point into the new order, once.
  void permute(Array<std::uint32_t>& values);
  /// Gives back the permutation's memory, where points stay as they are from now on.
  void forget_order();
  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(cell_keys_.size()); }
  CellGridView view() const { return {cell_keys_.data(), cell_begins_.data(), cell_count()}; }
  std::size_t memory_bytes() const;

 private:
  Scratch scratch_;
  Array<std::uint32_t> order_, other_order_;
  Array<std::uint64_t> keys_, other_keys_;  ///< of each point
  Array<std::uint8_t> begins_cell_;         ///< per point: whether it is the first of its cell
  Array<std::uint64_t> cell_keys_;
  Array<std::uint32_t> cell_begins_;
};

}  // namespace spindrift::sim::inline device
