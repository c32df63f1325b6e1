#include "sim/boundary/domain_walls.hpp"

#include "sim/core/open_faces.hpp"

namespace spindrift::sim {

std::vector<glm::vec3> sample_walls(const DomainSettings& domain, float spacing) {
  auto points = points_on_box({domain.min - 0.5f * spacing, domain.max + 0.5f * spacing}, spacing);
  const OpenFaces open(domain);
  std::erase_if(points, [&](const glm::vec3& p) { return open.is_beyond({p.x, p.y, p.z}); });
  return points;
}

glm::vec3 wall_lattice_step(const DomainSettings& domain, float spacing) {
  const glm::vec3 size = domain.max - domain.min + spacing;
  return size / glm::vec3(steps_across(size, spacing));
}

}  // namespace spindrift::sim
