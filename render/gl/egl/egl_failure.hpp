// Explains why no EGL device can be drawn with, and what to do about it.
#pragma once

#include <string>
#include <vector>

namespace spindrift::gl {

/// Returns those variables of an environment that steer EGL and Mesa, as NAME=VALUE in alphabetical
/// order; EGL_LOG_LEVEL, which steers messages only, is left out.
/// @param environment texts NAME=VALUE, then a null pointer
std::vector<std::string> steering_variables(const char* const* environment);

/// Says in one sentence why no EGL context could be made: what the system gives too little of, or
/// which variable is set, or else which package is missing.
/// @param reason why the last device that was tried failed; empty where there was none
std::string egl_failure(const std::string& reason);

}  // namespace spindrift::gl
