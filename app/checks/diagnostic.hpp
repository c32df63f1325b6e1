// The form in which the checks of a scene report errors and warnings before these are printed or
// thrown.
#pragma once

#include <string>

namespace spindrift::app {

/// What is wrong with a value of a scene, or what the user is to be warned of.
struct Diagnostic {
  std::string path;     ///< the value's key path, such as fluid.emitters[0]
  std::string message;  ///< what is said of the value
};

}  // namespace spindrift::app
