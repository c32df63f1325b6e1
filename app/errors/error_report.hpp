// Errors and warnings are reported here: in words on stderr and, for other programs, as JSON on
// stdout.
#pragma once

#include <string>

#include "app/errors/errors.hpp"
#include "app/errors/scene_error.hpp"

namespace spindrift::app {

/// Prints "spindrift: MESSAGE" to stderr, with the prefix before every line of the message and
/// control characters escaped. With `json` it also prints
/// {"errors": [{"message": …}], "exit_code": …} to stdout.
/// @return `code`
ExitCode tell_error(ExitCode code, const std::string& message, bool json);

/// Reports every problem of a scene in the same form. In JSON each problem has its "source",
/// "line", "column" and "path" as well, where these are known.
/// @return bad_usage
ExitCode tell_error(const SceneError& error, bool json);

/// Prints only the JSON of an error whose words are on stderr already.
void print_error_json(ExitCode code, const std::string& message);

/// Prints "spindrift: warning: MESSAGE" to stderr.
void tell_warning(const std::string& message);

}  // namespace spindrift::app
