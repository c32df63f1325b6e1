#include "sim/backend/device/cell_grid.hpp"

#include "sim/backend/device/algorithms.hpp"
#include "sim/backend/device/loops.hpp"

namespace spindrift::sim::inline device {

void CellGrid::sort(const GridMap& map, const PointView& points, std::uint32_t count) {
  order_.renew(count);
  other_order_.renew(count);
  keys_.renew(count);
  other_keys_.renew(count);
  std::uint32_t *order = order_.data(), *other_order = other_order_.data();
  std::uint64_t *keys = keys_.data(), *other_keys = other_keys_.data();
  launch(count, [=] SPINDRIFT_HD(std::uint32_t k) {
    keys[k] = map.key(points[k]);
    order[k] = k;
  });
  sort_pairs(scratch_, count, bits_below(map.key_count()), keys, other_keys, order, other_order);
  if (order != order_.data())
    order_.swap(other_order_);
  if (keys != keys_.data())
    keys_.swap(other_keys_);

  keys = keys_.data();
  cell_begins_.renew(std::size_t{count} + 1);
  std::uint32_t* begins = cell_begins_.data();
  begins_cell_.renew(count);
  std::uint8_t* begins_cell = begins_cell_.data();
  launch(count,
         [=] SPINDRIFT_HD(std::uint32_t k) { begins_cell[k] = k == 0 || keys[k] != keys[k - 1]; });
  const std::uint32_t cells = find_flagged(scratch_, begins_cell, count, begins);
  cell_keys_.renew(cells);
  cell_begins_.renew(std::size_t{cells} + 1);
  std::uint64_t* cell_keys = cell_keys_.data();
  launch(cells + 1, [=] SPINDRIFT_HD(std::uint32_t c) {
    if (c < cells)
      cell_keys[c] = keys[begins[c]];
    else
      begins[c] = count;
  });
}

void CellGrid::permute(Array<std::uint32_t>& values) {
  const auto n = static_cast<std::uint32_t>(order_.size());
  const std::uint32_t *order = order_.data(), *from = values.data();
  other_order_.renew(n);
  std::uint32_t* to = other_order_.data();
  launch(n, [=] SPINDRIFT_HD(std::uint32_t k) { to[k] = from[order[k]]; });
  values.swap(other_order_);
}

void CellGrid::forget_order() {
  wait();
  order_ = {};
  other_order_ = {};
  keys_ = {};
  begins_cell_ = {};
  other_keys_ = {};
}

std::size_t CellGrid::memory_bytes() const {
  return bytes_of(scratch_, begins_cell_, keys_, other_keys_, cell_keys_, order_, other_order_,
                  cell_begins_);
}

}  // namespace spindrift::sim::inline device
