// Sweeps, as a command.
#pragma once

#include <filesystem>
#include <string>

#include "app/sweep/sweep_plan.hpp"

namespace spindrift::app {

struct SweepOptions {
  std::filesystem::path output;   ///< folder of all results
  int threads = 1;                ///< of all runs together
  int jobs = 0;                   ///< runs at once, at most; 0: as many as there are threads
  bool quiet = false;             ///< nothing but errors
  bool json = false;              ///< for machines
  std::string command_line_hint;  ///< the command as typed, to say how to go on
};

/// Runs what of a sweep is not done yet, and leaves a report of all of it.
int run_sweep(const SweepRequest& request, const SweepOptions& options);

/// One task of a sweep, in a process of its own: told by JSON on the standard input.
int run_sweep_job();

}  // namespace spindrift::app
