#include "sim/shapes.hpp"

#include <cmath>
#include <numbers>

#include "sim/open_faces.hpp"
#include "sim/shapes/mesh_body.hpp"
#include "sim/solid.hpp"

namespace spindrift::sim {
namespace {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;  // which clang 14 does not find by itself

/// How many steps of a lattice stretched to end exactly at both corners of a box.
glm::ivec3 steps_across(glm::vec3 size, float d) {
  return glm::max(glm::ivec3(glm::round(size / d)), glm::ivec3(1));
}

/// Surface of a box of points.
std::vector<glm::vec3> box_surface(glm::vec3 min, glm::vec3 max, float d) {
  const glm::ivec3 n = steps_across(max - min, d);
  const glm::vec3 step = (max - min) / glm::vec3(n);
  std::vector<glm::vec3> points;
  for (int k = 0; k <= n.z; ++k)
    for (int j = 0; j <= n.y; ++j) {
      const bool on_face = j == 0 || j == n.y || k == 0 || k == n.z;
      for (int i = 0; i <= n.x; i += on_face ? 1 : n.x)
        points.push_back(min + step * glm::vec3(i, j, k));
    }
  return points;
}

/// Surface of a capsule `length` long between the centres of its ends, or of a ball where that is
/// 0. A spiral with equal area per point: the height along the axis falls evenly, since a zone of a
/// ball has the area of a cylinder's (Archimedes), and the angle grows by the golden angle.
/// @param frame three directions at right angles; the second is the axis
std::vector<glm::vec3> round_surface(glm::vec3 center, const glm::mat3& frame, float length,
                                     float radius, float d) {
  const double half = length / (2. * radius);  // in radii
  const double area = 4 * std::numbers::pi * radius * radius * (1 + half);
  const int n = std::max(1, static_cast<int>(std::lround(area / (d * d))));
  const double golden_angle = std::numbers::pi * (3 - std::sqrt(5.0));
  std::vector<glm::vec3> points;
  for (int k = 0; k < n; ++k) {
    const double y = (1 + half) * (1 - (2 * k + 1) / static_cast<double>(n));
    const double beyond = std::max(0., std::abs(y) - half);
    const double ring = std::sqrt(1 - beyond * beyond), angle = golden_angle * k;
    const glm::vec3 place(ring * std::cos(angle), y, ring * std::sin(angle));
    points.push_back(center + radius * (frame * place));
  }
  return points;
}

/// Rings up the side and concentric rings on both ends.
std::vector<glm::vec3> cylinder_surface(glm::vec3 from, glm::vec3 to, float radius, float d) {
  const glm::vec3 axis = glm::normalize(to - from), u = across(axis), v = glm::cross(axis, u);
  std::vector<glm::vec3> points;
  const auto add_ring = [&](glm::vec3 center, float r) {
    const int n = std::max(1, static_cast<int>(std::lround(2 * std::numbers::pi * r / d)));
    for (int k = 0; k < n; ++k) {
      const float angle =
          2 * std::numbers::pi_v<float> * static_cast<float>(k) / static_cast<float>(n);
      points.push_back(center + r * (std::cos(angle) * u + std::sin(angle) * v));
    }
  };
  const int layers = std::max(1, static_cast<int>(std::lround(glm::length(to - from) / d)));
  for (int k = 0; k <= layers; ++k)
    add_ring(from + (to - from) * (static_cast<float>(k) / static_cast<float>(layers)), radius);
  const int rings = static_cast<int>(std::lround(radius / d));
  for (int k = 0; k < rings; ++k) {
    const float r = radius * static_cast<float>(k) / static_cast<float>(rings);
    add_ring(from, r);
    add_ring(to, r);
  }
  return points;
}

}  // namespace

std::vector<SurfaceSample> sample_surface(const Shape& shape, float spacing) {
  if (const TriangleMesh* mesh = std::get_if<TriangleMesh>(&shape))
    return mesh->body->sample(spacing);
  const float inset = 0.5f * spacing;
  const auto below = [inset](float radius) { return std::max(radius - inset, 0.1f * radius); };
  const auto points = std::visit(
      Overloaded{[&](const Box& b) {
                   const glm::vec3 most = 0.5f * (b.max - b.min);
                   const glm::vec3 in = glm::min(glm::vec3(inset), most);
                   return box_surface(b.min + in, b.max - in, spacing);
                 },
                 [&](const Sphere& s) {
                   return round_surface(s.center, glm::mat3(1), 0, below(s.radius), spacing);
                 },
                 [&](const Cylinder& c) {
                   const glm::vec3 axis = c.to - c.from;
                   const float length = glm::length(axis);
                   const glm::vec3 in = axis * (std::min(inset, 0.4f * length) / length);
                   return cylinder_surface(c.from + in, c.to - in, below(c.radius), spacing);
                 },
                 [&](const Capsule& c) {
                   const float length = glm::length(c.to - c.from);
                   const glm::vec3 axis = (c.to - c.from) / length;
                   const glm::vec3 u = across(axis), v = glm::cross(axis, u);
                   return round_surface(0.5f * (c.from + c.to), {u, axis, v}, length,
                                        below(c.radius), spacing);
                 },
                 [](const TriangleMesh&) { return std::vector<glm::vec3>(); }},
      shape);
  std::vector<SurfaceSample> samples;
  for (const glm::vec3& p : points)
    samples.push_back({p});
  return samples;
}

std::vector<glm::vec3> sample_walls(const DomainSettings& domain, float spacing) {
  auto points = box_surface(domain.min - 0.5f * spacing, domain.max + 0.5f * spacing, spacing);
  const OpenFaces open(domain);
  std::erase_if(points, [&](const glm::vec3& p) { return open.is_beyond({p.x, p.y, p.z}); });
  return points;
}

glm::vec3 wall_lattice_step(const DomainSettings& domain, float spacing) {
  const glm::vec3 size = domain.max - domain.min + spacing;
  return size / glm::vec3(steps_across(size, spacing));
}

Box bounds_of(const Shape& shape) {
  return std::visit(
      Overloaded{[](const Box& b) { return b; },
                 [](const Sphere& s) {
                   return Box{s.center - s.radius, s.center + s.radius};
                 },
                 [](const Cylinder& c) {
                   const glm::vec3 axis = glm::normalize(c.to - c.from);
                   const glm::vec3 reach = c.radius * glm::sqrt(glm::max(1.f - axis * axis, 0.f));
                   return Box{glm::min(c.from, c.to) - reach, glm::max(c.from, c.to) + reach};
                 },
                 [](const Capsule& c) {
                   return Box{glm::min(c.from, c.to) - c.radius, glm::max(c.from, c.to) + c.radius};
                 },
                 [](const TriangleMesh& m) { return m.body->bounds(); }},
      shape);
}

bool is_inside(const Shape& shape, const glm::vec3& p) {
  return contains(shape, {p.x, p.y, p.z});
}

}  // namespace spindrift::sim
