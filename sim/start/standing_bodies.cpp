#include "sim/start/standing_bodies.hpp"

#include <algorithm>
#include <utility>

#include "sim/boundary/obstacle_motion.hpp"

namespace spindrift::sim {
namespace {

/// The sample points of a cell along each axis. A body's face that lies midway between two layers
/// of particles, or on a layer, falls between sample points.
constexpr int parts_along = 4;
constexpr int parts_in_cell = parts_along * parts_along * parts_along;

/// A tree of the obstacles' bounding boxes at time 0.
BoxTree tree_of(const std::vector<Obstacle>& obstacles) {
  std::vector<Box> boxes;
  for (const Obstacle& obstacle : obstacles)
    boxes.push_back(bounds_at(pose_at(obstacle, 0), bounds_of(obstacle.shape)));
  return BoxTree(std::move(boxes));
}

}  // namespace

StandingBodies::StandingBodies(const Settings& settings) : places_(tree_of(settings.obstacles)) {
  for (const Obstacle& obstacle : settings.obstacles)
    bodies_.push_back({&obstacle.shape, solid_of(obstacle.shape), pose_at(obstacle, 0)});
}

StandingBodies::Part StandingBodies::part_inside(const glm::vec3& center,
                                                 const glm::vec3& step) const {
  const glm::vec3 first = center + step * (0.5f / parts_along - 0.5f);
  const glm::vec3 between = step / float{parts_along};
  thread_local std::vector<std::uint32_t> near;
  places_.find({first, first + between * float{parts_along - 1}}, near);
  Part part;
  int inside = 0, most = 0;
  for (const std::uint32_t b : near) {
    const int points = count_inside(bodies_[b], places_[b], first, between);
    inside += points;
    if (points > most) {
      most = points;
      part.body = b;
    }
    if (inside >= parts_in_cell)
      break;
  }
  part.inside = std::min(1., inside / double{parts_in_cell});
  return part;
}

/// The number of a cell's sample points that are in a body.
/// @param bounds the body's bounding box where it stands, m
/// @param first the lowest sample point, m
/// @param between the distances of sample points along each axis, m
int StandingBodies::count_inside(const Body& body, const Box& bounds, const glm::vec3& first,
                                 const glm::vec3& between) {
  // Clamped before the conversion to int, since a body may reach farther than an int does.
  const glm::vec3 low = glm::ceil((bounds.min - first) / between),
                  high = glm::floor((bounds.max - first) / between);
  const glm::ivec3 from(glm::clamp(low, 0.f, float{parts_along}));
  const glm::ivec3 to(glm::clamp(high, -1.f, float{parts_along - 1}));
  int points = 0;
  for (int k = from.z; k <= to.z; ++k)
    for (int j = from.y; j <= to.y; ++j)
      for (int i = from.x; i <= to.x; ++i)
        points += body.solid.contains(body.back(first + between * glm::vec3(i, j, k)));
  return points;
}

glm::vec3 StandingBodies::push_out(glm::vec3 p) const {
  thread_local std::vector<std::uint32_t> near;
  places_.find({p, p}, near);
  for (std::size_t k = 0; k < near.size();) {
    const std::uint32_t number = near[k++];
    const Body& body = bodies_[number];
    const glm::vec3 q = body.back(p);
    const glm::vec3 out = body.solid.push_out(q);
    if (out == q)
      continue;
    p = glm::vec3(body.pose(glm::dvec3(out)));
    places_.find({p, p}, near);  // bodies after this one may contain the new point
    k = static_cast<std::size_t>(std::upper_bound(near.begin(), near.end(), number) - near.begin());
  }
  return p;
}

std::vector<glm::vec3> StandingBodies::samples_in(const Box& box, float spacing) const {
  std::vector<std::uint32_t> near;
  places_.find(box, near);
  std::vector<glm::vec3> samples;
  for (const std::uint32_t b : near)
    for (const SurfaceSample& sample : sample_surface(*bodies_[b].shape, spacing)) {
      const glm::vec3 p(bodies_[b].pose(glm::dvec3(sample.position)));
      if (is_in(box, p))
        samples.push_back(p);
    }
  return samples;
}

}  // namespace spindrift::sim
