// Runs another program to its end.
#pragma once

#include <atomic>
#include <string>
#include <string_view>
#include <vector>

namespace spindrift::app {

struct ProcessResult {
  int exit_code = 0;     ///< as in a shell: 128 plus the signal's number where a signal ended it
  std::string out, err;  ///< what the program wrote to its standard output and standard error
};

/// Runs a program with `input` as its standard input, and waits for its end.
/// @param command the program, by its path or looked for in PATH, and its arguments
/// @param stop kills the program when it becomes true
/// @throws std::system_error when the program can't be started
ProcessResult run_process(const std::vector<std::string>& command, std::string_view input,
                          const std::atomic<bool>& stop);

}  // namespace spindrift::app
