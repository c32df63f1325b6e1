#include "sim/geometry/mesh/mesh_body.hpp"

#include "sim/geometry/mesh/mesh_samples.hpp"

namespace spindrift::geometry {
namespace {

/// The depth inside the body, in spacings, down to which the grid's distances are right.
constexpr float right_down_to = 1.5f;

}  // namespace

Box bounds_of(const TriangleSurface& surface) {
  const glm::vec3& first = surface.vertices[surface.triangles[0].x];
  Box box{first, first};
  for (const glm::uvec3& t : surface.triangles)
    for (int k = 0; k < 3; ++k) {
      box.min = glm::min(box.min, surface.vertices[t[k]]);
      box.max = glm::max(box.max, surface.vertices[t[k]]);
    }
  return box;
}

MeshBody::MeshBody(TriangleSurface surface, float spacing)
    : surface_(std::move(surface)),
      bounds_(bounds_of(surface_)),
      tree_(surface_),
      grid_(tree_, bounds_.min, bounds_.max, 0.5f * spacing, right_down_to * spacing),
      view_{tree_.view(), grid_.view(), right_down_to * spacing, 0.05f * spacing} {}

std::vector<SurfaceSample> MeshBody::sample(float spacing) const {
  return sample_mesh(surface_, tree_, spacing);
}

}  // namespace spindrift::geometry
