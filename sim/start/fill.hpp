// Where liquid starts: lattices of particles that fit the volumes they fill.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim/core/settings.hpp"
#include "sim/core/stop.hpp"

namespace spindrift::sim {

/// The points origin + step (i, j, k) + offset, m, with i, j and k from `first` on.
struct Lattice {
  glm::vec3 origin{0.f}, step{1.f};  ///< m
  glm::vec3 offset{0.f};             ///< steps
  glm::ivec3 first{0}, counts{0};

  glm::vec3 point(const glm::ivec3& ijk) const {
    return origin + step * (glm::vec3(first + ijk) + offset);
  }
};

/// The lattice whose cells fill a box from face to face, with as many layers along each axis as
/// make their distance come nearest to the spacing: the spacing itself where the box is a whole
/// number of spacings wide. No layer where it is narrower than half a spacing.
Lattice lattice_in(const Box& box, float spacing);

/// The same where a cell is to hold as much as a cube of another edge: of the lattices near the
/// spacing, one that is near to that and little deformed.
/// @param edge m
Lattice lattice_in(const Box& box, float spacing, float edge);

/// The edge of the cube of liquid that one particle of a scene stands for, m: the spacing that is
/// asked for or, where the largest volume is not a whole number of spacings wide, the one that
/// shares that volume's liquid out evenly among the particles that fill it from face to face.
float particle_spacing(const Settings& settings);

struct FilledShape {
  std::vector<glm::vec3> points;  ///< x fastest, m
  glm::vec3 step;                 ///< between neighbours along each axis, m
};
/// What fills a shape. A box, and the bounds of a mesh, are filled by
/// lattice_in(box, spacing, edge). In other shapes the lattice's step is `edge`, but along a
/// cylinder that lies along an axis, which it fits as it does a box; it is put where it holds the
/// shape's volume as nearly as can be.
/// @param spacing that is asked for, m @param edge as particle_spacing() says, m
/// @throws Stopped
FilledShape fill_shape(const Shape& shape, float spacing, float edge, Stop stop = nullptr);
inline std::vector<glm::vec3> fill_shape(const Shape& shape, float spacing) {
  return fill_shape(shape, spacing, spacing).points;
}

/// The part of a shape that is inside the domain where it is a box, else the shape.
Shape within_domain(const Shape& shape, const DomainSettings& domain);

}  // namespace spindrift::sim
