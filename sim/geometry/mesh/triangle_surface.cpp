#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::geometry {

double enclosed_volume(const TriangleSurface& surface) {
  if (surface.triangles.empty())
    return 0;
  const glm::dvec3 origin(surface.vertices[surface.triangles.front().x]);
  double sum = 0;
  for (const glm::uvec3& t : surface.triangles) {
    const glm::dvec3 a(surface.vertices[t.x]), b(surface.vertices[t.y]), c(surface.vertices[t.z]);
    sum += glm::dot(a - origin, glm::cross(b - origin, c - origin));
  }
  return sum / 6;
}

double area_of(const TriangleSurface& surface) {
  double sum = 0;
  for (const glm::uvec3& t : surface.triangles) {
    const glm::dvec3 a(surface.vertices[t.x]), b(surface.vertices[t.y]), c(surface.vertices[t.z]);
    sum += 0.5 * glm::length(glm::cross(b - a, c - a));
  }
  return sum;
}

}  // namespace spindrift::geometry
