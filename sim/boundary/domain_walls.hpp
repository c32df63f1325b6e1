// Positions of the boundary particles of the domain's walls.
#pragma once

#include <vector>

#include "sim/core/settings.hpp"

namespace spindrift::sim {

/// Positions of the boundary particles of the domain's walls, m: half a spacing (m) outside its
/// closed faces, on a lattice that is aligned with the liquid's where the domain is a whole number
/// of spacings wide.
std::vector<glm::vec3> sample_walls(const DomainSettings& domain, float spacing);

/// The distances between neighbouring boundary particles of the walls along x, y and z, m; each is
/// about the spacing.
glm::vec3 wall_lattice_step(const DomainSettings& domain, float spacing);

}  // namespace spindrift::sim
