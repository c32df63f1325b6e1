// Neighbour lists: for every particle, the points closer than a search radius. No list has a cap.
//
// A list is a sequence of indices padded to whole batches of eight with the index of a sentinel
// point that lies far from everything, so that sums over a list need no remainder loop and no mask.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/openmp/cell_grid.hpp"
#include "sim/real.hpp"

namespace spindrift::sim {

/// Where the sentinel lies, m: outside every support radius, its square still finite in single
/// precision.
constexpr float sentinel_position = 1e15f;

/// Read access to the lists, for use inside the per-particle formulas.
struct NeighbourView {
  const std::uint32_t* const* first = nullptr;
  const std::uint32_t* batches = nullptr;

  /// Whether particle i of `count` has no other of its own kind near it: after itself, the padding
  /// begins.
  bool alone(std::uint32_t i, std::uint32_t count) const { return first[i][1] == count; }

  /// Σⱼ f(j) over the neighbours j of particle i; f takes eight indices and returns Lanes or
  /// Vec3<Lanes>.
  template <class F>
  auto sum(std::uint32_t i, F f) const {
    decltype(f(IndexLanes{})) total{};
    const std::uint32_t* j = first[i];
    for (std::uint32_t b = batches[i]; b > 0; --b, j += lane_count) {
      IndexLanes lanes;
      __builtin_memcpy(&lanes, j, sizeof lanes);
      total += f(lanes);
    }
    return reduce(total);
  }
};

class NeighbourLists {
 public:
  /// Lists, for each of the `count` sorted points of `grid`, the points of `other_grid` within
  /// `radius`, which is at most the cell size of `map`. Where both are the same set, a point is its
  /// own neighbour. `others` holds one more point than `other_count`, the sentinel, and room for a
  /// whole batch after it.
  void build(const GridMap& map, const CellGrid& grid, const Vec3Arrays& points,
             std::uint32_t count, const CellGrid& other_grid, const Vec3Arrays& others,
             std::uint32_t other_count, float radius);

  NeighbourView view() const { return {first_.data(), batches_.data()}; }
  std::size_t memory_bytes() const;

 private:
  std::vector<const std::uint32_t*> first_;
  std::vector<std::uint32_t> batches_;
  std::vector<std::vector<std::uint32_t>> blocks_;  ///< one buffer per block of cells
};

}  // namespace spindrift::sim
