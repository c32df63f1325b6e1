// Parses the command line and runs the command on it.
#pragma once

namespace spindrift::app {

/// Runs the command that was typed and returns the exit code. Errors are printed to stderr, a
/// sentence each, and with --json to stdout as JSON as well.
int run_command_line(int argc, const char* const* argv);

}  // namespace spindrift::app
