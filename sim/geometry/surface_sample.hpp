// A sample of a solid's surface: the point at which a boundary particle is placed.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

namespace spindrift::geometry {

/// A point a little below a surface that represents the piece of surface around it.
struct SurfaceSample {
  /// Which surface the sample represents.
  enum class Side {
    domain,  ///< a wall of the domain, sampled on a lattice along flat faces that meet at edges
    around,  ///< the surface of a thick solid near the sample
    one,     ///< the side of a thin wall that the normal points to; another layer has the other
    both,    ///< both sides of a wall so thin that a single layer lies in its middle
  };

  glm::vec3 position;  ///< m
  Side side = Side::around;
  glm::vec3 normal{0.f};                               ///< unit vector out of a thin wall; else 0
  std::optional<float> wall_viscosity = std::nullopt;  ///< Pa·s; nullopt: the fluid's
};

/// Samples at these points (m) that represent the surface around them.
inline std::vector<SurfaceSample> samples_at(const std::vector<glm::vec3>& points) {
  std::vector<SurfaceSample> samples;
  samples.reserve(points.size());
  for (const glm::vec3& p : points)
    samples.push_back({p});
  return samples;
}

}  // namespace spindrift::geometry
