// What can be wrong with emitters, sinks and open faces.
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.hpp"

namespace spindrift::app {

/// What is wrong with a value of a scene, and which.
struct Complaint {
  std::string path, message;
};

/// What is wrong with a scene's emitters, the first thing of each, and with its open faces.
std::vector<Complaint> check_exchange(const Scene& scene);

}  // namespace spindrift::app
