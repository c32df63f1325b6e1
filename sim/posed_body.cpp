#include "sim/posed_body.hpp"

#include <algorithm>
#include <cmath>

#include "sim/open_faces.hpp"
#include "sim/shapes.hpp"
#include "sim/solid.hpp"

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

bool overlap(const Vec3<float>& low, const Vec3<float>& high, const Box& box, float margin) {
  return low.x <= box.max.x + margin && low.y <= box.max.y + margin &&
         low.z <= box.max.z + margin && high.x >= box.min.x - margin &&
         high.y >= box.min.y - margin && high.z >= box.min.z - margin;
}

bool is_zero(const Vec3<float>& v) {
  return v.x == 0 && v.y == 0 && v.z == 0;
}

/// How a body pushes a point out of itself along the shortest way, in the scene's frame; 0 outside.
Vec3<float> shortest_push(const PosedBody& body, const Vec3<float>& p) {
  const Vec3<float> q = body.pose.back(p);
  const Vec3<float> out = push_out(*body.shape, q);
  return is_zero(out - q) ? Vec3<float>{0, 0, 0} : body.pose(out) - p;
}

/// Half the thickness of a shape where that is known; a mesh is not seen where it is thinner than
/// half a spacing.
float half_thickness(const Shape& shape, float spacing) {
  if (const Box* box = std::get_if<Box>(&shape)) {
    const glm::vec3 size = box->max - box->min;
    return 0.5f * std::min({size.x, size.y, size.z});
  }
  if (const Sphere* ball = std::get_if<Sphere>(&shape))
    return ball->radius;
  if (const Capsule* capsule = std::get_if<Capsule>(&shape))
    return capsule->radius;
  if (const Cylinder* cylinder = std::get_if<Cylinder>(&shape))
    return std::min(cylinder->radius, 0.5f * glm::distance(cylinder->from, cylinder->to));
  return 0.25f * spacing;
}

/// Particles this near to a wall, in spacings, count as in a body that lies flush against it.
constexpr float nudge = 1e-3f;

/// Moves one coordinate of a point off the wall that it is pushed into, if it is.
void lift_off(float push, float out, float low, float high, float lift, float& coordinate) {
  const float margin = nudge * lift;
  if (push < 0 && out < low + margin)
    coordinate = low + lift;
  if (push > 0 && out > high - margin)
    coordinate = high - lift;
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

float Inside::beyond(const Vec3<float>& p) const {
  return std::max({min.x - p.x, min.y - p.y, min.z - p.z, p.x - max.x, p.y - max.y, p.z - max.z});
}

Vec3<float> Inside::nudged(const Vec3<float>& p, float distance) const {
  return {std::clamp(p.x, min.x + distance, max.x - distance),
          std::clamp(p.y, min.y + distance, max.y - distance),
          std::clamp(p.z, min.z + distance, max.z - distance)};
}

Vec3<float> PosedBody::hold(const Vec3<float>& p) const {
  const Vec3<float> inner = domain.nudged(p, nudge * spacing);
  const Vec3<float> q = pose.back(inner);
  if (!overlap(q, q, bounds, 0))
    return p;
  const Vec3<float> shortest = shortest_push(*this, inner);
  if (is_zero(shortest))
    return p;
  // Where the way out leads into a wall, the particle takes that of a point farther off that wall.
  for (float lift = spacing; lift > 0.2f * spacing; lift *= 0.5f) {
    Vec3<float> lifted = inner, push = shortest;
    for (int walls = 0; walls <= 3 && !is_zero(push); ++walls) {
      const Vec3<float> out = lifted + push, before = lifted;
      lift_off(push.x, out.x, domain.min.x, domain.max.x, lift, lifted.x);
      lift_off(push.y, out.y, domain.min.y, domain.max.y, lift, lifted.y);
      lift_off(push.z, out.z, domain.min.z, domain.max.z, lift, lifted.z);
      if (is_zero(lifted - before))
        return walls == 0 ? out : p + push;
      push = shortest_push(*this, lifted);
    }
  }
  return inner + shortest;
}

Vec3<float> PosedBody::sweep(const Vec3<float>& from, const Vec3<float>& p) const {
  constexpr float most_pieces = 1000;
  const Vec3<float> first = start.back(from), last = pose.back(p);
  const Vec3<float> low{std::min(first.x, last.x), std::min(first.y, last.y),
                        std::min(first.z, last.z)};
  const Vec3<float> high{std::max(first.x, last.x), std::max(first.y, last.y),
                         std::max(first.z, last.z)};
  if (!overlap(low, high, bounds, 2e-3f * spacing))
    return p;
  const Vec3<float> way = last - first;
  const float pieces = std::clamp(std::ceil(square_root(dot(way, way)) / reach), 1.f, most_pieces);
  const Vec3<float> piece = (1 / pieces) * way;
  Vec3<float> q = first;
  bool held = false;
  for (int k = 0; k < static_cast<int>(pieces); ++k) {
    q = q + piece;
    const Vec3<float> free = pose(q), out = hold(free);
    if (is_zero(out - free))
      continue;
    held = true;
    q = pose.back(out);
  }
  return held ? pose(q) : p;
}

bool PosedBody::holds(const Vec3<float>& p) const {
  return !is_zero(shortest_push(*this, domain.nudged(p, nudge * spacing)));
}

float PosedBody::depth(const Vec3<float>& p) const {
  const Vec3<float> q = pose.back(p);
  if (!overlap(q, q, bounds, 0))
    return 0;
  const Vec3<float> push = push_out(*shape, q) - q;
  return square_root(dot(push, push));
}

std::vector<PosedBody> posed_bodies(const Settings& settings, double start, double end) {
  std::vector<PosedBody> bodies;
  const float spacing = settings.fluid.spacing;
  const Inside domain(settings.domain);
  for (const Obstacle& obstacle : settings.obstacles) {
    if (!obstacle.motion)
      continue;
    const Pose before = pose_at(obstacle, start), after = pose_at(obstacle, end);
    PosedBody body;
    body.shape = &obstacle.shape;
    body.bounds = bounds_of(obstacle.shape);
    body.domain = domain;
    body.start = affine(before.rotation, before.translation);
    body.pose = affine(after.rotation, after.translation);
    const double per_second = end > start ? 1 / (end - start) : 0;
    body.velocity = affine(per_second * (after.rotation - before.rotation),
                           per_second * (after.translation - before.translation));
    body.spacing = spacing;
    body.reach =
        std::max(std::min(0.25f, 0.8f * half_thickness(obstacle.shape, spacing) / spacing), 0.02f) *
        spacing;
    bodies.push_back(body);
  }
  return bodies;
}

}  // namespace spindrift::sim
