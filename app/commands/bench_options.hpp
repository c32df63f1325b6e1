// The command-line options of `bench`.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/bench/bench.hpp"
#include "app/commands/common_options.hpp"
#include "app/errors/errors.hpp"

namespace spindrift::app {

/// The options of `bench` as typed. A list that is empty stands for that of the default plan.
struct TypedBench : TypedCommon {
  std::string output;
  std::vector<std::string> scenes;
  std::vector<std::string> solvers;
  std::vector<double> spacing_factors, tolerance_factors, time_step_factors;
  std::vector<int> particle_counts;
  double limit_seconds =
      BenchPlan{}.limit_seconds;  ///< wall-clock time after which a run is given up
  bool quick = false;
  bool plane = false, scaling = false, threads_scaling = false;
};

/// Adds the options to a command; parsing stores their values in `typed`, which must outlive it.
void add_bench_options(CLI::App& command, TypedBench& typed);

/// Runs `bench` with the options typed, and returns the exit code.
/// @throws SceneError, UsageError
int run_typed_bench(const TypedBench& typed);

}  // namespace spindrift::app
