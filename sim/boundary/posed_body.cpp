#include "sim/boundary/posed_body.hpp"

#include <algorithm>
#include <cmath>

#include "sim/boundary/obstacle_motion.hpp"
#include "sim/core/open_faces.hpp"

namespace spindrift::sim {
namespace {

Vec3<float> from(const glm::dvec3& v) {
  const glm::vec3 single(v);
  return {single.x, single.y, single.z};
}

Affine affine(const glm::dmat3& m, const glm::dvec3& offset) {
  const glm::dmat3 rows = glm::transpose(m);
  return {from(rows[0]), from(rows[1]), from(rows[2]), from(offset)};
}

}  // namespace

Inside::Inside(const DomainSettings& domain)
    : min{domain.min.x, domain.min.y, domain.min.z}, max{domain.max.x, domain.max.y, domain.max.z} {
  constexpr float never = OpenFaces::never;
  const OpenFaces open(domain);
  const auto remove = [](float& low, float& high, float open_low, float open_high) {
    low = open_low > -never ? -never : low;
    high = open_high < never ? never : high;
  };
  remove(min.x, max.x, open.min.x, open.max.x);
  remove(min.y, max.y, open.min.y, open.max.y);
  remove(min.z, max.z, open.min.z, open.max.z);
}

std::vector<Solid> solids_of(const std::vector<Obstacle>& obstacles) {
  std::vector<Solid> solids;
  for (const Obstacle& obstacle : obstacles)
    solids.push_back(solid_of(obstacle.shape));
  return solids;
}

std::vector<PosedBody> posed_bodies(const Settings& settings, double start, double end) {
  return posed_bodies(settings, solids_of(settings.obstacles), start, end);
}

std::vector<PosedBody> posed_bodies(const Settings& settings, std::span<const Solid> solids,
                                    double start, double end) {
  std::vector<PosedBody> bodies;
  const float spacing = settings.fluid.spacing;
  const Inside domain(settings.domain);
  for (std::size_t k = 0; k < solids.size(); ++k) {
    const Obstacle& obstacle = settings.obstacles[k];
    if (!obstacle.motion)
      continue;
    const Pose before = pose_at(obstacle, start), after = pose_at(obstacle, end);
    PosedBody body;
    body.solid = solids[k];
    body.bounds = bounds_of(obstacle.shape);
    body.domain = domain;
    body.start = affine(before.rotation, before.translation);
    body.pose = affine(after.rotation, after.translation);
    const double per_second = end > start ? 1 / (end - start) : 0;
    body.velocity = affine(per_second * (after.rotation - before.rotation),
                           per_second * (after.translation - before.translation));
    body.spacing = spacing;
    bodies.push_back(body);
  }
  return bodies;
}

}  // namespace spindrift::sim
