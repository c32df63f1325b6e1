#include "sim/standing_bodies.hpp"

#include "sim/shapes.hpp"

namespace spindrift::sim {
namespace {

/// Points along each axis at which a cell is looked at; those of a face between two layers fall
/// between them.
constexpr int parts_along = 4;

bool is_within_reach(const Box& box, const glm::vec3& p, float reach) {
  return glm::all(glm::greaterThan(p, box.min - reach)) &&
         glm::all(glm::lessThan(p, box.max + reach));
}

}  // namespace

StandingBodies::StandingBodies(const Settings& settings) {
  for (const Obstacle& obstacle : settings.obstacles)
    bodies_.push_back({&obstacle.shape, solid_of(obstacle.shape), bounds_of(obstacle.shape),
                       pose_at(obstacle, 0)});
}

StandingBodies::Part StandingBodies::part_inside(const glm::vec3& center,
                                                 const glm::vec3& step) const {
  Part part;
  int inside = 0, most = 0;
  for (std::size_t b = 0; b < bodies_.size(); ++b) {
    const Body& body = bodies_[b];
    if (!is_within_reach(body.bounds, body.back(center), glm::length(step)))
      continue;
    int points = 0;
    for (int k = 0; k < parts_along; ++k)
      for (int j = 0; j < parts_along; ++j)
        for (int i = 0; i < parts_along; ++i) {
          const glm::vec3 at = (glm::vec3(i, j, k) + 0.5f) / float{parts_along} - 0.5f;
          points += contains(body.solid, from_glm(body.back(center + step * at)));
        }
    inside += points;
    if (points > most) {
      most = points;
      part.body = b;
    }
  }
  part.inside = std::min(1., inside / std::pow(parts_along, 3));
  return part;
}

glm::vec3 StandingBodies::push_out(glm::vec3 p) const {
  for (const Body& body : bodies_) {
    const glm::vec3 q = body.back(p);
    if (!is_within_reach(body.bounds, q, 0))
      continue;
    const glm::vec3 out = to_glm(sim::push_out(body.solid, from_glm(q)));
    if (out != q)
      p = glm::vec3(body.pose(glm::dvec3(out)));
  }
  return p;
}

std::vector<glm::vec3> StandingBodies::samples_in(const Box& box, float spacing) const {
  std::vector<glm::vec3> samples;
  for (const Body& body : bodies_)
    for (const SurfaceSample& sample : sample_surface(*body.shape, spacing)) {
      const glm::vec3 p(body.pose(glm::dvec3(sample.position)));
      if (is_within_reach(box, p, 0))
        samples.push_back(p);
    }
  return samples;
}

}  // namespace spindrift::sim
