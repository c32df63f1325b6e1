// What can be run, but will hardly give what its author expects.
#pragma once

#include <string>
#include <vector>

#include "app/scene.hpp"

namespace spindrift::app {

/// A sentence for each such thing in a scene that has passed its checks: "PATH: what was found,
/// what comes of it, and what to do".
std::vector<std::string> scene_warnings(const Scene& scene);

}  // namespace spindrift::app
