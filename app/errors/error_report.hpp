// How errors and warnings are told: in words on stderr and, for machines, as JSON on stdout.
#pragma once

#include <string>

#include "app/errors/errors.hpp"
#include "app/errors/scene_error.hpp"

namespace spindrift::app {

/// Prints "spindrift: MESSAGE" to stderr, each of its lines so, without control characters. With
/// `json` also {"errors": [{"message": …}], "exit_code": …} to stdout. Returns the code.
ExitCode tell_error(ExitCode code, const std::string& message, bool json);

/// The same for all that is wrong with a scene; in JSON each problem has its "source", "line",
/// "column" and "path" as well, where these are known.
ExitCode tell_error(const SceneError& error, bool json);

/// Only the JSON, of an error that has been told in words.
void print_error_json(ExitCode code, const std::string& message);

/// Prints "spindrift: warning: MESSAGE" to stderr.
void tell_warning(const std::string& message);

}  // namespace spindrift::app
