// Copies of shapes beside each other.
#pragma once

#include <glm/glm.hpp>

namespace spindrift::geometry {

/// Takes a place x to offset + direction x.
struct Mirror {
  glm::vec3 offset{0.f};     ///< m
  glm::vec3 direction{1.f};  ///< -1 along an axis: mirrored

  glm::vec3 operator()(const glm::vec3& place) const { return offset + direction * place; }
};

}  // namespace spindrift::geometry
