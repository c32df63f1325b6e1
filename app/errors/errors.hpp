// How a command ends, and what it throws when it cannot go on.
#pragma once

#include <stdexcept>

namespace spindrift::app {

/// What a command tells the shell.
enum ExitCode {
  done = 0,
  check_failed = 1,
  bad_usage = 2,  ///< or bad input
  run_failed = 3,
};

/// Input that can't be used, other than a scene. The message is one sentence for people: the file,
/// what was found and what is accepted.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Misuse of the command line; the message is one sentence for people.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace spindrift::app
