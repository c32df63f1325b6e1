// Why there is nothing to draw with, and what to do.
#pragma once

#include <string>
#include <vector>

namespace spindrift::gl {

/// The variables of the environment that steer EGL and Mesa, as NAME=VALUE.
std::vector<std::string> steering_variables(const char* const* environment);

/// One sentence about why no EGL context could be made: what the system gives too little of, or
/// which variable is set, or else which package is missing.
/// @param reason of the last device that was tried; empty: there was none
std::string egl_failure(const std::string& reason);

}  // namespace spindrift::gl
