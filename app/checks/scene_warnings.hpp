// What a scene asks for and can't have, though it can be simulated.
#pragma once

#include <vector>

#include "app/checks/exchange_checks.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// Meshes with cavities, liquid that has no place, in litres asked for and got, obstacles outside
/// the domain, emitters that bring nothing, and a speed of sound (sph) that lets the liquid be
/// compressed; each with the path of what is meant.
std::vector<Complaint> warnings_of(const Scene& scene);

/// Prints them to standard error.
void print_warnings(const Scene& scene);

}  // namespace spindrift::app
