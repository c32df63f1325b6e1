// A reflection along coordinate axes, with which copies of shapes and of whole scenes are placed
// beside each other.
#pragma once

#include <glm/glm.hpp>

namespace spindrift::geometry {

/// Maps a point x to offset + direction · x, component by component.
struct Mirror {
  glm::vec3 offset{0.f};     ///< m
  glm::vec3 direction{1.f};  ///< −1 along an axis that is mirrored, else 1

  glm::vec3 operator()(const glm::vec3& place) const { return offset + direction * place; }
};

}  // namespace spindrift::geometry
