// The command `sweep`, which runs a scene with many values.
#pragma once

#include <filesystem>
#include <string>

#include "app/sweep/sweep_plan.hpp"

namespace spindrift::app {

struct SweepOptions {
  std::filesystem::path output;   ///< folder of all results
  int threads = 1;                ///< number of threads of all runs together
  int jobs = 0;                   ///< most runs at once; 0: as many as there are threads
  bool quiet = false;             ///< print nothing but errors
  bool json = false;              ///< print results as JSON
  std::string command_line_hint;  ///< the command as typed, for the hint how to continue
};

/// Runs all tasks of a sweep that are not done yet, and writes sweep.json, sweep.csv and
/// report.html.
/// @return the exit code
/// @throws SceneError for runs, a reference, targets or times that can't be used
int run_sweep(const SweepRequest& request, const SweepOptions& options);

/// Does one task of a sweep, which JSON on the standard input describes. A sweep starts a process
/// for each of its tasks, which calls this.
/// @return the exit code
int run_sweep_job();

}  // namespace spindrift::app
