// Sorts points by cell on the processor's cores.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/backend/cells.hpp"
#include "sim/backend/openmp/arrays.hpp"

namespace spindrift::sim::inline openmp {

/// The occupied cells of a sorted set of points.
class CellGrid {
 public:
  /// Sorts by cell; equal keys keep their order. Returns the permutation: new place k holds old
  /// point `order()[k]`.
  void sort(const GridMap& map, const PointView& points, std::uint32_t count);

  const std::vector<std::uint32_t>& order() const { return order_; }
  /// Brings one number per point into the new order, once.
  void permute(std::vector<std::uint32_t>& values);
  /// Gives back the permutation's memory, where points stay as they are from now on.
  void forget_order();
  std::uint32_t cell_count() const { return static_cast<std::uint32_t>(cell_keys_.size()); }
  CellGridView view() const { return {cell_keys_.data(), cell_begin_.data(), cell_count()}; }
  std::uint64_t cell_key(std::uint32_t c) const { return cell_keys_[c]; }
  /// First point of cell c; c may be cell_count(), then it is the number of points.
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
