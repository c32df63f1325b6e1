#include "app/draw/obstacle_mesh.hpp"

#include <utility>
#include <vector>

#include "sim/boundary/obstacle_motion.hpp"

namespace spindrift::app {

Mesh tessellate(std::span<const sim::Obstacle> obstacles) {
  geometry::Tessellation all;
  for (const sim::Obstacle& obstacle : obstacles)
    geometry::tessellate(all, obstacle.shape);
  return {std::move(all.vertices), std::move(all.normals), std::move(all.triangles)};
}

ObstacleMeshes::ObstacleMeshes(std::span<const sim::Obstacle> obstacles) {
  for (const sim::Obstacle& obstacle : obstacles) {
    parts_.push_back({obstacle, tessellate({&obstacle, 1})});
    moves_ = moves_ || obstacle.motion;
  }
}

Mesh ObstacleMeshes::at(double time) const {
  Mesh all;
  for (const Part& part : parts_) {
    const sim::Pose pose = sim::pose_at(part.obstacle, time);
    const auto first = static_cast<unsigned>(all.vertices.size());
    for (std::size_t i = 0; i < part.mesh.vertices.size(); ++i) {
      const glm::vec3 &vertex = part.mesh.vertices[i], &normal = part.mesh.normals[i];
      const bool moves = part.obstacle.motion.has_value();
      all.vertices.push_back(moves ? glm::vec3(pose(vertex)) : vertex);
      all.normals.push_back(moves ? glm::vec3(pose.rotation * glm::dvec3(normal)) : normal);
    }
    for (const glm::uvec3& triangle : part.mesh.triangles)
      all.triangles.push_back(triangle + first);
  }
  return all;
}

std::vector<glm::vec3> ObstacleMeshes::reach(std::span<const double> instants) const {
  glm::dvec3 low(1e30), high(-1e30);
  for (const Part& part : parts_) {
    if (!part.obstacle.motion)
      continue;
    const sim::Box box = sim::bounds_of(part.obstacle.shape);
    for (const double time : instants) {
      const sim::Pose pose = sim::pose_at(part.obstacle, time);
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p =
            pose({(corner & 1) ? box.max.x : box.min.x, (corner & 2) ? box.max.y : box.min.y,
                  (corner & 4) ? box.max.z : box.min.z});
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
  }
  if (!moves_ || instants.empty())
    return {};
  const double rounding = 1e-4 * glm::distance(low, high);
  return {glm::vec3(low - rounding), glm::vec3(high + rounding)};
}

}  // namespace spindrift::app
