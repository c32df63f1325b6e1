// The open faces of the domain, which have no wall, and tests of points against them.
#pragma once

#include <limits>

#include "sim/core/real.hpp"
#include "sim/core/settings.hpp"

namespace spindrift::sim {

/// The planes of a domain's open faces.
struct OpenFaces {
  static constexpr float never = std::numeric_limits<float>::infinity();
  bool any = false;  ///< whether any face is open
  /// Coordinates of the open faces, m; infinite in place of faces with a wall.
  Vec3<float> min{-never, -never, -never}, max{never, never, never};

  OpenFaces() = default;
  explicit OpenFaces(const DomainSettings& domain) : any(!domain.open.empty()) {
    float* const low[] = {&min.x, &min.y, &min.z};
    float* const high[] = {&max.x, &max.y, &max.z};
    for (const Direction face : domain.open) {
      const int axis = static_cast<int>(face) / 2;
      if (static_cast<int>(face) % 2 == 0)
        *high[axis] = domain.max[axis];
      else
        *low[axis] = domain.min[axis];
    }
  }

  /// Whether a point is inside the domain, or outside it only beyond open faces.
  bool is_before(const Vec3<float>& p, const DomainSettings& domain) const {
    const auto out = [](float v, float lo, float hi, float open_lo, float open_hi) {
      return (v < lo && v >= open_lo) || (v > hi && v <= open_hi);
    };
    return !(out(p.x, domain.min.x, domain.max.x, min.x, max.x) ||
             out(p.y, domain.min.y, domain.max.y, min.y, max.y) ||
             out(p.z, domain.min.z, domain.max.z, min.z, max.z));
  }

  /// Whether a point is beyond the plane of an open face.
  SPINDRIFT_HD bool is_beyond(const Vec3<float>& p) const {
    return p.x < min.x || p.y < min.y || p.z < min.z || p.x > max.x || p.y > max.y || p.z > max.z;
  }
};

}  // namespace spindrift::sim
