// Neighbour lists: for every particle, the points closer than a search radius. No list has a cap.
//
// A list is a sequence of places (LaneList), padded to whole batches of eight with the place of a
// sentinel, a point far from all others, so that sums over a list need no remainder loop and no
// mask.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "sim/backend/openmp/cell_grid.hpp"
#include "sim/core/real.hpp"

namespace spindrift::sim::inline openmp {

/// Coordinate of the sentinel, m: outside every support radius, and its square is still finite in
/// single precision.
constexpr float sentinel_position = 1e15f;

/// Read access to the lists, for use inside the per-particle formulas.
struct NeighbourView {
  const std::uint32_t* place = nullptr;          ///< place of each particle's list in the chunks
  const std::uint32_t* const* chunks = nullptr;  ///< memory of the lists, `chunk_size` numbers each
  static constexpr int chunk_bits = 14;
  static constexpr std::size_t chunk_size = std::size_t{1} << chunk_bits;

  /// The list of particle i: the number of its batches of eight places, then those places.
  const std::uint32_t* list(std::uint32_t i) const {
    return chunks[place[i] >> chunk_bits] + (place[i] & (chunk_size - 1));
  }
  bool empty(std::uint32_t i) const { return *list(i) == 0; }

  /// Whether particle i of `count` has no neighbour but itself, in lists of one set of points: the
  /// padding begins after itself.
  bool is_alone(std::uint32_t i, std::uint32_t count) const {
    return list(i)[2] == LaneList::place_of(count);
  }

  /// Calls f(j) for the neighbours j of particle i, and perhaps for the sentinel.
  template <class F>
  void for_each(std::uint32_t i, F f) const {
    const std::uint32_t* j = list(i);
    for (std::uint32_t left = *j++ * lane_count; left > 0; --left, ++j)
      f(LaneList::number_at(*j));
  }

  /// Σⱼ f(j) over the neighbours j of particle i; f takes eight of them and returns Lanes
  /// or Vec3<Lanes>.
  template <class F>
  auto sum(std::uint32_t i, F f) const {
    decltype(f(LaneList{})) total{};
    const std::uint32_t* j = list(i);
    for (std::uint32_t b = *j++; b > 0; --b, j += lane_count)
      total += f(LaneList{j});
    return reduce(total);
  }
};

/// A sum over runs of consecutive points.
class RunSum {
 public:
  /// Adds f(j) for all j in [begin, end). f takes eight of them, which may go on beyond the end.
  template <class F>
  void add(std::uint32_t begin, std::uint32_t end, F f) {
    constexpr IndexLanes lane{0, 1, 2, 3, 4, 5, 6, 7};
    for (std::uint32_t j = begin; j < end; j += lane_count) {
      const Lanes value = f(LaneRun{j});
      const Lanes zero{};
      total_ += lane < static_cast<std::int32_t>(end - j) ? value : zero;
    }
  }
  float value() const { return reduce(total_); }

 private:
  Lanes total_{};
};

/// Calls use(j, value_at(j)) for all j in [begin, end). value_at takes eight of them, which may go
/// on beyond the end.
template <class Value, class F>
void for_run(std::uint32_t begin, std::uint32_t end, Value value_at, F use) {
  for (std::uint32_t j = begin; j < end; j += lane_count) {
    const Lanes values = value_at(LaneRun{j});
    for (std::uint32_t k = 0; k < lane_count && j + k < end; ++k)
      use(j + k, values[k]);
  }
}

/// Builds and holds the neighbour lists of one set of points.
class NeighbourLists {
 public:
  /// Lists, for each of the `count` sorted points of `grid`, the points of `other_grid` within
  /// `radius`, which is at most the cell size of `map`. Where both are the same set, a point is its
  /// own neighbour. `others` holds one more point than `other_count`, the sentinel, and room for a
  /// whole batch after it.
  /// @throws std::length_error when there are more than four billion neighbours in all, or more
  ///         other points than places have bits for
  void build(const GridMap& map, const CellGrid& grid, const PointView& points, std::uint32_t count,
             const CellGrid& other_grid, const PointView& others, std::uint32_t other_count,
             float radius);

  NeighbourView view() const { return {place_.data(), table_.data()}; }
  std::size_t memory_bytes() const;

 private:
  class Writer;
  using Chunk = std::unique_ptr<std::uint32_t[]>;

  std::vector<std::uint32_t> place_;         ///< as in NeighbourView
  std::vector<const std::uint32_t*> table_;  ///< the chunks in use; the first is the empty list
  std::vector<Chunk> chunks_;                ///< kept from one build to the next
  std::vector<std::vector<std::uint32_t>> large_;  ///< memory of lists longer than a chunk
  std::size_t taken_ = 0;                          ///< number of `chunks_` in use
};

}  // namespace spindrift::sim::inline openmp
