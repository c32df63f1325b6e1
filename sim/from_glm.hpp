// Vectors of scenes as vectors of formulas.
#pragma once

#include <glm/glm.hpp>

#include "sim/real.hpp"

namespace spindrift::sim {

SPINDRIFT_HD inline Vec3<float> from_glm(glm::vec3 v) {
  return {v.x, v.y, v.z};
}

}  // namespace spindrift::sim
