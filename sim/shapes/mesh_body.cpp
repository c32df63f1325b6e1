#include "sim/shapes/mesh_body.hpp"

#include "sim/shapes/mesh_samples.hpp"

namespace spindrift::sim {

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
      depth_(1.5f * spacing),
      tolerance_(0.05f * spacing),
      grid_(tree_, bounds_.min, bounds_.max, 0.5f * spacing, depth_) {}

glm::vec3 MeshBody::push_out(const glm::vec3& p) const {
  const DistanceGrid::Value value = grid_.at(p);
  if (value.distance >= 0)
    return p;
  const float slope = glm::length(value.gradient);
  if (value.distance > -depth_ && slope > 0.5f) {
    const glm::vec3 out = p - (value.distance / slope) * value.gradient;
    if (grid_.at(out).distance > -tolerance_)
      return out;
  }
  // Midway between two sides, and far inside, the gradient does not tell the way out.
  return tree_.nearest(p).point;
}

std::vector<SurfaceSample> MeshBody::sample(float spacing) const {
  return sample_mesh(surface_, tree_, spacing);
}

}  // namespace spindrift::sim
