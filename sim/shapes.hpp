// Sampling of shapes: layers of points on surfaces for walls.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim/settings.hpp"
#include "sim/shapes/surface_sample.hpp"

namespace spindrift::sim {

/// Points below the surface of an obstacle, half a spacing deep, about one per spacing².
std::vector<SurfaceSample> sample_surface(const Shape& shape, float spacing);

/// Points on the walls of the domain, half a spacing outside its faces, on a lattice that is
/// aligned with the liquid's where the domain is a whole number of spacings wide, m.
std::vector<glm::vec3> sample_walls(const DomainSettings& domain, float spacing);

/// Distance between neighbouring samples of the walls along x, y and z, m; about the spacing.
glm::vec3 wall_lattice_step(const DomainSettings& domain, float spacing);

/// Whether a point, m, is inside a shape.
bool is_inside(const Shape& shape, const glm::vec3& p);

/// The smallest box around a shape.
Box bounds_of(const Shape& shape);

/// Whether two boxes have nothing in common.
inline bool is_apart(const Box& a, const Box& b) {
  return glm::any(glm::lessThan(a.max, b.min)) || glm::any(glm::greaterThan(a.min, b.max));
}

}  // namespace spindrift::sim
