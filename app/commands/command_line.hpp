// The command line: what was typed, into a command and its options.
#pragma once

namespace spindrift::app {

/// Runs the command typed and returns the exit code. Errors go to stderr, a sentence each,
/// and with --json to stdout as well.
int run_command_line(int argc, const char* const* argv);

}  // namespace spindrift::app
