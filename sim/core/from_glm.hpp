// Conversions between glm vectors, as scenes and frames have them, and the Vec3 of the formulas.
#pragma once

#include <glm/glm.hpp>

#include "sim/core/real.hpp"

namespace spindrift::sim {

SPINDRIFT_HD inline Vec3<float> from_glm(glm::vec3 v) {
  return {v.x, v.y, v.z};
}

SPINDRIFT_HD inline glm::vec3 to_glm(const Vec3<float>& v) {
  return {v.x, v.y, v.z};
}

}  // namespace spindrift::sim
