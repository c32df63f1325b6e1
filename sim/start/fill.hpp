// The initial lattices of fluid particles, fitted to the volumes that they fill.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim/core/settings.hpp"
#include "sim/core/stop.hpp"

namespace spindrift::sim {

/// A rectangular lattice: the points origin + step · ((i, j, k) + offset), in which i, j and k
/// count from `first` on.
struct Lattice {
  glm::vec3 origin{0.f}, step{1.f};  ///< m
  glm::vec3 offset{0.f};             ///< in steps
  glm::ivec3 first{0}, counts{0};    ///< smallest index and number of points along each axis

  /// The point with these indices, each from 0 to its count less 1, m.
  glm::vec3 point(const glm::ivec3& ijk) const {
    return origin + step * (glm::vec3(first + ijk) + offset);
  }
};

/// The lattice whose cells fill a box from face to face. The number of layers along each axis is
/// the one whose step comes nearest to the spacing (m); where the box is a whole number of spacings
/// wide, the step is the spacing itself. A box narrower than half a spacing gets no layer.
Lattice lattice_in(const Box& box, float spacing);

/// Does the same where a cell is to hold as much as a cube of a given edge: among the lattices near
/// the spacing, one whose cells are close to that volume and little deformed.
/// @param edge of that cube, m
Lattice lattice_in(const Box& box, float spacing, float edge);

/// The edge of the cube of liquid that one particle of a scene represents, m. It is the spacing
/// that the settings ask for or, where the largest volume is not a whole number of spacings wide,
/// the edge that shares that volume's liquid out evenly among the particles that fill it from face
/// to face.
float particle_spacing(const Settings& settings);

/// The points of a lattice that are inside a shape.
struct FilledShape {
  std::vector<glm::vec3> points;  ///< x fastest, m
  glm::vec3 step;                 ///< of the lattice along each axis, m
};
/// Fills a shape with a lattice. A box, and the bounding box of a mesh, are filled by
/// lattice_in(box, spacing, edge). In other shapes the lattice's step is `edge`, except along the
/// axis of a cylinder that is parallel to a coordinate axis, which the lattice fits as it does a
/// box; the lattice is shifted to where it holds the shape's volume as nearly as possible.
/// @param spacing that the settings ask for, m
/// @param edge particle_spacing() of the settings, m
/// @throws Stopped
FilledShape fill_shape(const Shape& shape, float spacing, float edge, Stop stop = nullptr);
/// The points that fill a shape where one particle represents a cube of the spacing (m), m.
inline std::vector<glm::vec3> fill_shape(const Shape& shape, float spacing) {
  return fill_shape(shape, spacing, spacing).points;
}

/// The part of a box that is inside the domain; any other shape is returned unchanged.
Shape within_domain(const Shape& shape, const DomainSettings& domain);

}  // namespace spindrift::sim
