// Checks the parts of a scene through which liquid enters and leaves: emitters and open faces.
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.hpp"

namespace spindrift::app {

/// A problem with a value of a scene: the value's key path, such as fluid.emitters[0], and what is
/// wrong with it.
struct Complaint {
  std::string path, message;
};

/// The problems of a scene's open faces, and the first problem of each of its emitters.
std::vector<Complaint> check_exchange(const Scene& scene);

}  // namespace spindrift::app
