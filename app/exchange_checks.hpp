// What can be wrong with emitters, sinks and open faces.
#pragma once

#include <optional>
#include <string>

#include "app/scene.hpp"

namespace spindrift::app {

/// What is wrong with a value of a scene, and which.
struct Complaint {
  std::string path, message;
};

/// The first thing that is wrong with a scene's emitters, sinks and open faces.
std::optional<Complaint> check_exchange(const Scene& scene);

}  // namespace spindrift::app
