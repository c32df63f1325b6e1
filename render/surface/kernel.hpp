// Defines the smoothing kernel that particles add to the scalar field of the surface.
#pragma once

#include "render/lanes.hpp"

namespace spindrift::surface {

/// Returns the constant factor of the smoothing kernel W(r) = 315 / (64 pi h^3) (1 - r^2/h^2)^3 of
/// Mueller et al. 2003, which needs no square root. W(r) is computed as
/// kernel_scale(h) * kernel_shape(1 - r^2/h^2), with the distance r and the support radius h in
/// particle spacings.
inline float kernel_scale(float support) {
  return 315.0f / (8.0f * 64.0f * 3.14159265f * support * support * support);
}

/// Returns 8 max(t, 0)^3 for every lane.
inline Lanes kernel_shape(Lanes t) {
  const Lanes twice = t + absolute(t);
  return twice * twice * twice;
}

}  // namespace spindrift::surface
