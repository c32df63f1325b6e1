// The command-line options of `sweep`, which runs a scene with many values.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/sweep/sweep.hpp"

namespace spindrift::app {

/// The options of `sweep` as typed.
struct TypedSweep {
  std::string file;                  ///< a scene file or a sweep file
  std::vector<std::string> values;   ///< values of --set, each KEY=VALUE,VALUE,...
  std::string output;                ///< empty: out/<file>_sweep
  std::string reference;             ///< run that all are compared with; empty: as the file says
  std::vector<std::string> targets;  ///< values of --target, each METRIC=NUMBER
  std::vector<double> times;         ///< when pictures are set side by side, s
  int threads = 0;                   ///< of all runs together; 0: as many as the machine has
  int jobs = 0;                      ///< most runs at once; 0: as many as threads
  bool quiet = false;
  bool json = false;
};

/// Adds the options to a command; parsing stores their values in `typed`, which must outlive it.
void add_sweep_options(CLI::App& command, TypedSweep& typed);

/// Runs `sweep` with the options typed, and returns the exit code.
/// @param hint the command as typed, for the message how to continue it
/// @throws SceneError
int run_typed_sweep(const TypedSweep& typed, const std::string& hint);

}  // namespace spindrift::app
