// How evenly points are spread over a surface.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <vector>

#include "sim/geometry/surface_sample.hpp"

namespace spindrift::test {

inline std::vector<glm::vec3> positions(const std::vector<geometry::SurfaceSample>& samples) {
  std::vector<glm::vec3> points;
  for (const geometry::SurfaceSample& sample : samples)
    points.push_back(sample.position);
  return points;
}

/// Distance from a point to the nearest other one, m.
inline float distance_to_nearest(const glm::vec3& p, const std::vector<glm::vec3>& points) {
  float squared = std::numeric_limits<float>::infinity();
  for (const glm::vec3& q : points)
    if (q != p)
      squared = std::min(squared, glm::dot(p - q, p - q));
  return std::sqrt(squared);
}

struct Spread {
  float closest = std::numeric_limits<float>::infinity();  ///< pair of points, m
  float loneliest = 0;  ///< largest distance from a point to its nearest neighbour, m
  float hole = 0;       ///< largest distance from a place on the surface to its nearest point, m
};

/// @param places many points on the surface that the others are to be spread over
inline Spread spread(const std::vector<glm::vec3>& points, const std::vector<glm::vec3>& places) {
  Spread s;
  for (const glm::vec3& p : points) {
    const float nearest = distance_to_nearest(p, points);
    s.closest = std::min(s.closest, nearest);
    s.loneliest = std::max(s.loneliest, nearest);
  }
  for (const glm::vec3& p : places)
    s.hole = std::max(s.hole, distance_to_nearest(p, points));
  return s;
}

}  // namespace spindrift::test
