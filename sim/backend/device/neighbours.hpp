// Neighbour lists on the device: for every particle, the points closer than a search radius. No
// list has a cap.
//
// Particles are in groups of 32, as many as a warp has threads. The lists of a group have the
// length of its longest one, and are interleaved, so that the threads, each at the k-th neighbour
// of its own particle, read indices that stand beside each other:
//
//   neighbour k of particle 32 g + l is   numbers[ 32 (begins[g] + k) + l ]
#pragma once

#include "sim/backend/cells.hpp"
#include "sim/backend/device/arrays.hpp"
#include "sim/backend/device/cell_grid.hpp"

namespace spindrift::sim::inline device {

/// Coordinate of the sentinel, a point that is near to no other, m: outside every support radius,
/// and its square is still finite in single precision.
constexpr float sentinel_position = 1e15f;

/// Read access to the lists, for use inside the per-particle formulas.
struct NeighbourView {
  const std::uint32_t* counts = nullptr;   ///< number of neighbours of each particle
  const std::uint64_t* begins = nullptr;   ///< start of each group's lists, in rows of 32 indices
  const std::uint32_t* numbers = nullptr;  ///< indices of the neighbours

  SPINDRIFT_HD bool empty(std::uint32_t i) const { return counts[i] == 0; }

  /// Whether particle i has no neighbour but itself, in lists of one set of points.
  SPINDRIFT_HD bool is_alone(std::uint32_t i, std::uint32_t) const { return counts[i] == 1; }

  /// Calls f(j) for the neighbours j of particle i.
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

/// A sum over runs of consecutive points.
class RunSum {
 public:
  /// Adds f(j) for all j in [begin, end).
  template <class F>
  SPINDRIFT_HD void add(std::uint32_t begin, std::uint32_t end, F f) {
    for (std::uint32_t j = begin; j < end; ++j)
      total_ += f(j);
  }
  SPINDRIFT_HD float value() const { return total_; }

 private:
  float total_ = 0;
};

/// Calls use(j, value_at(j)) for all j in [begin, end).
template <class Value, class F>
SPINDRIFT_HD void for_run(std::uint32_t begin, std::uint32_t end, Value value_at, F use) {
  for (std::uint32_t j = begin; j < end; ++j)
    use(j, value_at(j));
}

/// Builds and holds the neighbour lists of one set of points.
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
  Array<std::uint32_t> cell_of_;              ///< cell of each point
  Array<std::uint32_t> run_begin_, run_end_;  ///< runs of others around each cell, row by row
  Array<std::uint32_t> counts_;
  Array<std::uint64_t> begins_;
  Array<std::uint32_t> numbers_;
};

}  // namespace spindrift::sim::inline device
