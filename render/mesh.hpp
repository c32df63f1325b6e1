// Defines the indexed triangle mesh that the surface reconstruction hands to the renderer and to
// the mesh writer.
#pragma once

#include <glm/glm.hpp>
#include <vector>

namespace spindrift {

/// Triangles with shared vertices. Triangles wind counter-clockwise seen from outside the liquid.
struct Mesh {
  std::vector<glm::vec3> vertices;    ///< m
  std::vector<glm::vec3> normals;     ///< unit vertex normals, pointing out of the liquid
  std::vector<glm::uvec3> triangles;  ///< indices into `vertices`
};

}  // namespace spindrift
