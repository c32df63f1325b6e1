// Checks the parts of a scene through which liquid enters and leaves: emitters and open faces.
#pragma once

#include <vector>

#include "app/checks/diagnostic.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// The problems of a scene's open faces, and the first problem of each of its emitters.
std::vector<Diagnostic> check_exchange(const Scene& scene);

}  // namespace spindrift::app
