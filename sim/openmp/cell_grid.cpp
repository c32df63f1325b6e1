#include "sim/openmp/cell_grid.hpp"

#include <omp.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace spindrift::sim {
namespace {

constexpr int digit_bits = 8;
constexpr std::size_t digit_values = 1u << digit_bits;

/// One stable pass of a radix sort over the digit at `shift`: every thread counts and then places
/// one consecutive part of the input.
void radix_pass(const std::vector<std::uint64_t>& keys, const std::vector<std::uint32_t>& values,
                std::vector<std::uint64_t>& sorted_keys, std::vector<std::uint32_t>& sorted_values,
                int shift) {
  const std::size_t n = keys.size();
  std::vector<std::array<std::uint32_t, digit_values>> counts;
#pragma omp parallel
  {
    const auto threads = static_cast<std::size_t>(omp_get_num_threads());
    const auto t = static_cast<std::size_t>(omp_get_thread_num());
    const std::size_t begin = n * t / threads, end = n * (t + 1) / threads;
    const auto digit = [&](std::size_t i) { return (keys[i] >> shift) & (digit_values - 1); };
#pragma omp single
    counts.resize(threads);
    auto& mine = counts[t];
    mine.fill(0);
    for (std::size_t i = begin; i < end; ++i)
      ++mine[digit(i)];
#pragma omp barrier
#pragma omp single
    {
      std::uint32_t place = 0;
      for (std::size_t d = 0; d < digit_values; ++d)
        for (auto& c : counts)
          place += std::exchange(c[d], place);
    }
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t place = mine[digit(i)]++;
      sorted_keys[place] = keys[i];
      sorted_values[place] = values[i];
    }
  }
}

}  // namespace

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

void CellGrid::sort(const GridMap& map, const Vec3Arrays& points, std::uint32_t count) {
  keys_.resize(count);
  scratch_keys_.resize(count);
  order_.resize(count);
  scratch_order_.resize(count);
#pragma omp parallel for schedule(static)
  for (std::int64_t i = 0; i < std::int64_t{count}; ++i) {
    const auto k = static_cast<std::uint32_t>(i);
    keys_[k] = map.key(points[k]);
    order_[k] = k;
  }
  const int bits = static_cast<int>(std::bit_width(map.key_count()));
  for (int shift = 0; shift < bits; shift += digit_bits) {
    radix_pass(keys_, order_, scratch_keys_, scratch_order_, shift);
    keys_.swap(scratch_keys_);
    order_.swap(scratch_order_);
  }
  find_cells();
}

void CellGrid::find_cells() {
  cell_keys_.clear();
  cell_begin_.clear();
  for (std::uint32_t i = 0; i < keys_.size(); ++i) {
    if (i == 0 || keys_[i] != keys_[i - 1]) {
      cell_keys_.push_back(keys_[i]);
      cell_begin_.push_back(i);
    }
  }
  cell_begin_.push_back(static_cast<std::uint32_t>(keys_.size()));
}

std::size_t CellGrid::first_cell_from(std::uint64_t key) const {
  return static_cast<std::size_t>(std::lower_bound(cell_keys_.begin(), cell_keys_.end(), key) -
                                  cell_keys_.begin());
}

std::size_t CellGrid::memory_bytes() const {
  return (keys_.capacity() + scratch_keys_.capacity() + cell_keys_.capacity()) * 8 +
         (order_.capacity() + scratch_order_.capacity() + cell_begin_.capacity()) * 4;
}

const std::array<RowCursors::Run, 9>& RowCursors::around(std::uint64_t key) {
  const std::size_t n = grid_.cell_count();
  std::size_t row = 0;
  for (std::int64_t dz = -1; dz <= 1; ++dz) {
    for (std::int64_t dy = -1; dy <= 1; ++dy, ++row) {
      const auto low = static_cast<std::uint64_t>(static_cast<std::int64_t>(key) +
                                                  map_.nx * (dy + map_.ny * dz) - 1);
      std::size_t& first = first_[row];
      std::size_t& last = last_[row];
      if (!started_)
        first = last = grid_.first_cell_from(low);
      while (first < n && grid_.cell_key(first) < low)
        ++first;
      last = std::max(first, last);
      while (last < n && grid_.cell_key(last) <= low + 2)
        ++last;
      runs_[row] = {grid_.cell_begin(first), grid_.cell_begin(last)};
    }
  }
  started_ = true;
  return runs_;
}

}  // namespace spindrift::sim
