// Neighbour lists on the device: for every particle, the points closer than a search radius. No
// list has a cap.
//
// Particles stand in groups of 32, a warp's threads. A group's lists are as long as its longest
// one, and interleaved, so that the threads, each at the k-th neighbour of its own particle, read
// numbers that stand beside each other:
//
//   particle 32 g + l, neighbour k:   numbers[ 32 (begins[g] + k) + l ]
#pragma once

#include "sim/backend/cells.hpp"
#include "sim/backend/device/arrays.hpp"
#include "sim/backend/device/cell_grid.hpp"

namespace spindrift::sim::inline device {

/// Where a point lies that is near to none, m: outside every support radius, its square still
/// finite in single precision.
constexpr float sentinel_position = 1e15f;

/// Read access to the lists, for use inside the per-particle formulas.
struct NeighbourView {
  const std::uint32_t* counts = nullptr;   ///< of each particle's neighbours
  const std::uint64_t* begins = nullptr;   ///< of each group, in neighbours per particle
  const std::uint32_t* numbers = nullptr;  ///< of the neighbours

  SPINDRIFT_HD bool empty(std::uint32_t i) const { return counts[i] == 0; }

  /// Whether particle i has no other of its own kind near it.
  SPINDRIFT_HD bool alone(std::uint32_t i, std::uint32_t) const { return counts[i] == 1; }

  /// f(j) for the neighbours j of particle i.
  template <class F>
  SPINDRIFT_HD void for_each(std::uint32_t i, F f) const {
    const std::uint32_t* j = numbers + begins[i / lane_count] * lane_count + i % lane_count;
    for (std::uint32_t left = counts[i]; left > 0; --left, j += lane_count)
      f(*j);
  }

  /// Σⱼ f(j) over the neighbours j of particle i.
  template <class F>
  SPINDRIFT_HD auto sum(std::uint32_t i, F f) const {
    decltype(f(std::uint32_t{})) total{};
    for_each(i, [&](std::uint32_t j) { total += f(j); });
    return total;
  }
};

/// Adds up over points that follow each other.
class RunSum {
 public:
  /// Σⱼ f(j) for j in [begin, end).
  template <class F>
  SPINDRIFT_HD void add(std::uint32_t begin, std::uint32_t end, F f) {
    for (std::uint32_t j = begin; j < end; ++j)
      total_ += f(j);
  }
  SPINDRIFT_HD float value() const { return total_; }

 private:
  float total_ = 0;
};

/// use(j, value_at(j)) for j in [begin, end).
template <class Value, class F>
SPINDRIFT_HD void for_run(std::uint32_t begin, std::uint32_t end, Value value_at, F use) {
  for (std::uint32_t j = begin; j < end; ++j)
    use(j, value_at(j));
}

class NeighbourLists {
 public:
  /// Lists, for each of the `count` sorted points of `grid`, the points of `other_grid` within
  /// `radius`, which is at most the cell size of `map`. Where both are the same set, a point is its
  /// own neighbour.
  void build(const GridMap& map, const CellGrid& grid, const PointView& points, std::uint32_t count,
             const CellGrid& other_grid, const PointView& others, std::uint32_t other_count,
             float radius);

  NeighbourView view() const { return {counts_.data(), begins_.data(), numbers_.data()}; }
  std::size_t memory_bytes() const;

 private:
  Scratch scratch_;
  Array<std::uint32_t> cell_of_;              ///< each point's cell
  Array<std::uint32_t> run_begin_, run_end_;  ///< row by row of each cell: others around it
  Array<std::uint32_t> counts_;
  Array<std::uint64_t> begins_;
  Array<std::uint32_t> numbers_;
};

}  // namespace spindrift::sim::inline device
