// Triangles that bound a body.
#pragma once

#include <glm/glm.hpp>
#include <stdexcept>
#include <vector>

namespace spindrift::geometry {

/// Triangles with shared vertices, counter-clockwise seen from outside the body that they bound.
struct TriangleSurface {
  std::vector<glm::vec3> vertices;    ///< m
  std::vector<glm::uvec3> triangles;  ///< indices into `vertices`
};

/// A mesh that can't be used. The message says what is wrong with it, for people.
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Volume inside a closed surface, m³, where bodies overlap more than once; negative when its
/// triangles face inward.
double enclosed_volume(const TriangleSurface& surface);

/// Area of the triangles, m².
double area_of(const TriangleSurface& surface);

}  // namespace spindrift::geometry
