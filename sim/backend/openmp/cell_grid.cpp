#include "sim/backend/openmp/cell_grid.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <utility>

namespace spindrift::sim::inline openmp {
namespace {

constexpr int digit_bits = 11;
constexpr std::size_t digit_values = 1u << digit_bits;

/// One stable pass of a radix sort of points by the digit of their key at `shift`: every thread
/// counts and then places one consecutive part of the input. Keys are computed where they are
/// needed, which costs less than to carry them along.
/// @param point_at point_at(k) is the k-th point of the input
/// @param key_of   key_of(point) is the key of its cell
template <class PointAt, class KeyOf>
void radix_pass(std::uint32_t n, PointAt point_at, KeyOf key_of, int shift,
                std::vector<std::uint32_t>& sorted) {
  std::vector<std::array<std::uint32_t, digit_values>> counts;
#pragma omp parallel
  {
    const auto threads = static_cast<std::uint64_t>(omp_get_num_threads());
    const auto t = static_cast<std::uint64_t>(omp_get_thread_num());
    const auto begin = static_cast<std::uint32_t>(n * t / threads),
               end = static_cast<std::uint32_t>(n * (t + 1) / threads);
    const auto digit = [&](std::uint32_t point) {
      return (key_of(point) >> shift) & (digit_values - 1);
    };
#pragma omp single
    counts.resize(threads);
    auto& mine = counts[t];
    mine.fill(0);
    for (std::uint32_t k = begin; k < end; ++k)
      ++mine[digit(point_at(k))];
#pragma omp barrier
#pragma omp single
    {
      std::uint32_t place = 0;
      for (std::size_t d = 0; d < digit_values; ++d)
        for (auto& c : counts)
          place += std::exchange(c[d], place);
    }
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint32_t point = point_at(k);
      sorted[mine[digit(point)]++] = point;
    }
  }
}

}  // namespace

void CellGrid::sort(const GridMap& map, const PointView& points, std::uint32_t count) {
  order_.resize(count);
  scratch_.resize(count);
  const auto key_of = [&](std::uint32_t point) { return map.key(points[point]); };
  const int bits = static_cast<int>(std::bit_width(map.key_count()));
  radix_pass(
      count, [](std::uint32_t k) { return k; }, key_of, 0, order_);
  for (int shift = digit_bits; shift < bits; shift += digit_bits) {
    radix_pass(
        count, [&](std::uint32_t k) { return order_[k]; }, key_of, shift, scratch_);
    order_.swap(scratch_);
  }
  find_cells(key_of);
}

/// Every thread finds the cells that begin in one consecutive part of the points.
template <class KeyOf>
void CellGrid::find_cells(KeyOf key_of) {
  const auto n = static_cast<std::uint32_t>(order_.size());
  struct Cells {
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> begins;
  };
  std::vector<std::size_t> first_cell;
#pragma omp parallel
  {
    const auto threads = static_cast<std::uint64_t>(omp_get_num_threads());
    const auto t = static_cast<std::uint64_t>(omp_get_thread_num());
    const auto begin = static_cast<std::uint32_t>(n * t / threads),
               end = static_cast<std::uint32_t>(n * (t + 1) / threads);
    Cells found;
    std::uint64_t last = begin > 0 ? key_of(order_[begin - 1]) : ~std::uint64_t{0};
    for (std::uint32_t k = begin; k < end; ++k) {
      const std::uint64_t key = key_of(order_[k]);
      if (key != last) {
        found.keys.push_back(key);
        found.begins.push_back(k);
      }
      last = key;
    }
#pragma omp single
    first_cell.assign(threads + 1, 0);
    first_cell[t + 1] = found.keys.size();
#pragma omp barrier
#pragma omp single
    {
      std::partial_sum(first_cell.begin(), first_cell.end(), first_cell.begin());
      grow(cell_keys_, first_cell.back());
      grow(cell_begin_, first_cell.back() + 1);
      cell_begin_.back() = n;
    }
    std::copy(found.keys.begin(), found.keys.end(), cell_keys_.begin() + first_cell[t]);
    std::copy(found.begins.begin(), found.begins.end(), cell_begin_.begin() + first_cell[t]);
  }
}

void CellGrid::permute(std::vector<std::uint32_t>& values) {
  const auto n = static_cast<std::int64_t>(order_.size());
#pragma omp parallel for schedule(static)
  for (std::int64_t k = 0; k < n; ++k)
    scratch_[k] = values[order_[k]];
  values.swap(scratch_);
}

void CellGrid::forget_order() {
  order_ = {};
  scratch_ = {};
}

std::size_t CellGrid::memory_bytes() const {
  return bytes_of(cell_keys_, order_, scratch_, cell_begin_);
}

}  // namespace spindrift::sim::inline openmp
