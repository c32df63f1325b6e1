// A hash grid that finds points near a place, for work done once on the host at a run's start.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <unordered_map>
#include <vector>

namespace spindrift::sim {

/// Points hashed by the cells of a uniform grid.
class PointCells {
 public:
  /// @param points positions, m
  /// @param cell   edge of a cell, m
  PointCells(const std::vector<glm::vec3>& points, float cell) : cell_(cell) {
    for (std::uint32_t i = 0; i < points.size(); ++i)
      cells_[key(cell_of(points[i]))].push_back(i);
  }

  /// Calls f(i) for the index i of every point in the 27 cells around p: for all that are closer
  /// than a cell's edge, and for some that are farther.
  template <class F>
  void for_near(const glm::vec3& p, F f) const {
    const glm::ivec3 at = cell_of(p);
    for (int k = -1; k <= 1; ++k)
      for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
          if (const auto found = cells_.find(key(at + glm::ivec3(i, j, k))); found != cells_.end())
            for (const std::uint32_t n : found->second)
              f(n);
  }

 private:
  glm::ivec3 cell_of(const glm::vec3& p) const { return glm::ivec3(glm::floor(p / cell_)); }
  static std::uint64_t key(const glm::ivec3& c) {
    constexpr std::uint64_t mask = (1u << 21) - 1;
    return (static_cast<std::uint64_t>(c.x) & mask) |
           (static_cast<std::uint64_t>(c.y) & mask) << 21 |
           (static_cast<std::uint64_t>(c.z) & mask) << 42;
  }

  float cell_;  ///< m
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cells_;
};

}  // namespace spindrift::sim
