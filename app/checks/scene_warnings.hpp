// Warnings about scenes that can be simulated but will not do all that they ask for.
#pragma once

#include <vector>

#include "app/checks/diagnostic.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// The warnings of a scene, each with the key path of the value it is about. They concern meshes
/// with cavities, liquid that has no place (with the litres asked for and got), obstacles outside
/// the domain, emitters that bring nothing, and a speed of sound (solver type sph) so low that the
/// liquid would be compressed.
std::vector<Diagnostic> warnings_of(const Scene& scene);

/// Prints the warnings of a scene to standard error.
void print_warnings(const Scene& scene);

}  // namespace spindrift::app
