// The exit codes of the program's commands, and the exceptions for bad input and bad usage.
#pragma once

#include <stdexcept>

namespace spindrift::app {

/// The exit code that a command returns to the shell.
enum ExitCode {
  done = 0,
  check_failed = 1,  ///< a comparison or a check of a finished run found a difference or a fault
  bad_usage = 2,     ///< the command line or an input file can't be used
  run_failed = 3,    ///< the work itself failed or was interrupted
};

/// Input other than a scene that can't be used (for scenes see SceneError). The message is one
/// sentence for people that names the file, what was found and what is accepted.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A command line that can't be used. The message is one sentence for people.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace spindrift::app
