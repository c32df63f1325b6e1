#include "sim/shapes/measures.hpp"

#include <cmath>
#include <numbers>

#include "sim/shapes/mesh_body.hpp"

namespace spindrift::sim {
namespace {

using std::numbers::pi;

double volume(const Box& box) {
  const glm::dvec3 d = glm::max(glm::dvec3(box.max) - glm::dvec3(box.min), 0.);
  return d.x * d.y * d.z;
}
double area(const Box& box) {
  const glm::dvec3 d = glm::dvec3(box.max) - glm::dvec3(box.min);
  return 2 * (d.x * d.y + d.y * d.z + d.z * d.x);
}

double volume(const Sphere& sphere) {
  return 4. / 3 * pi * std::pow(double{sphere.radius}, 3);
}
double area(const Sphere& sphere) {
  return 4 * pi * std::pow(double{sphere.radius}, 2);
}

template <class Long>  // a cylinder or a capsule
double length(const Long& shape) {
  return glm::distance(glm::dvec3(shape.from), glm::dvec3(shape.to));
}

double volume(const Cylinder& cylinder) {
  const double radius = cylinder.radius;
  return pi * radius * radius * length(cylinder);
}
double area(const Cylinder& cylinder) {
  const double radius = cylinder.radius;
  return 2 * pi * radius * (radius + length(cylinder));
}

double volume(const Capsule& capsule) {
  const double radius = capsule.radius;
  return pi * radius * radius * (length(capsule) + 4. / 3 * radius);
}
double area(const Capsule& capsule) {
  const double radius = capsule.radius;
  return 2 * pi * radius * (length(capsule) + 2 * radius);
}

/// Tetrahedra from the origin to each triangle.
double volume(const TriangleMesh& mesh) {
  const TriangleSurface& surface = mesh.body->surface();
  double sum = 0;
  for (const glm::uvec3& t : surface.triangles) {
    const glm::dvec3 a(surface.vertices[t.x]), b(surface.vertices[t.y]), c(surface.vertices[t.z]);
    sum += glm::dot(a, glm::cross(b, c));
  }
  return sum / 6;
}
double area(const TriangleMesh& mesh) {
  const TriangleSurface& surface = mesh.body->surface();
  double sum = 0;
  for (const glm::uvec3& t : surface.triangles) {
    const glm::dvec3 a(surface.vertices[t.x]), b(surface.vertices[t.y]), c(surface.vertices[t.z]);
    sum += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return sum;
}

double area(const Disc& disc) {
  return pi * std::pow(double{disc.radius}, 2);
}
double area(const Rectangle& rectangle) {
  return double{rectangle.width} * rectangle.height;
}

}  // namespace

double volume_of(const Shape& shape) {
  return std::visit([](const auto& s) { return volume(s); }, shape);
}

double area_of(const Shape& shape) {
  return std::visit([](const auto& s) { return area(s); }, shape);
}

double area_of(const Opening& opening) {
  return std::visit([](const auto& o) { return area(o); }, opening);
}

}  // namespace spindrift::sim
