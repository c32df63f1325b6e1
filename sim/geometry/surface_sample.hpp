// A point that stands for a piece of a solid's surface.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace spindrift::geometry {

struct SurfaceSample {
  /// What the sample stands for.
  enum class Side {
    domain,  ///< a wall of the domain: a lattice along flat faces, bent at their edges
    around,  ///< the surface near it
    one,     ///< one side of a thin wall, that of the normal; a second layer stands for the other
    both,    ///< both sides of a wall so thin that there is a single layer, in its middle
  };

  glm::vec3 position;  ///< m
  Side side = Side::around;
  glm::vec3 normal{0.f};                               ///< out of a thin wall, unit; else 0
  std::optional<float> wall_viscosity = std::nullopt;  ///< Pa·s; none: the fluid's
};

/// Points of a surface as samples that stand for what is around them.
inline std::vector<SurfaceSample> samples_at(const std::vector<glm::vec3>& points) {
  std::vector<SurfaceSample> samples;
  samples.reserve(points.size());
  for (const glm::vec3& p : points)
    samples.push_back({p});
  return samples;
}

}  // namespace spindrift::geometry
