// An indexed triangle mesh that bounds a body, and its volume and area.
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

/// Thrown for a mesh that cannot be used. The message says what is wrong with it, for people.
class MeshError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The volume inside a closed surface, m³. Where bodies overlap, the overlap counts once for each;
/// the volume is negative if the triangles face inward.
double enclosed_volume(const TriangleSurface& surface);

/// The total area of the triangles, m².
double area_of(const TriangleSurface& surface);

}  // namespace spindrift::geometry
