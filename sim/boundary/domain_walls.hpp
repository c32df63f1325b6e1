// Points on the walls of the domain.
#pragma once

#include <vector>

#include "sim/core/settings.hpp"

namespace spindrift::sim {

/// Points on the walls of the domain, half a spacing outside its faces, on a lattice that is
/// aligned with the liquid's where the domain is a whole number of spacings wide, m.
std::vector<glm::vec3> sample_walls(const DomainSettings& domain, float spacing);

/// Distance between neighbouring samples of the walls along x, y and z, m; about the spacing.
glm::vec3 wall_lattice_step(const DomainSettings& domain, float spacing);

}  // namespace spindrift::sim
