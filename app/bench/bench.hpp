// The command `bench`, which measures the speed, memory and errors of simulations.
#pragma once

#include <filesystem>

#include "app/bench/bench_runs.hpp"

namespace spindrift::app {

struct BenchOptions {
  BenchPlan plan;
  std::filesystem::path output;  ///< folder of the table and the report
  bool quiet = false;            ///< print nothing but errors
  bool json = false;             ///< print results as JSON
};

/// Measures the speed, memory and errors of the plan's runs, and writes bench.csv and bench.html
/// into the output folder.
/// @return the exit code, run_failed where no run reached its end or the benchmark was interrupted
/// @throws SceneError for a scene that can't be used
int run_bench(const BenchOptions& options);

/// Measures one run of a benchmark. It is the main function of the process in which a run is
/// measured, and takes JSON from standard input to JSON on standard output.
/// @return the exit code
int run_bench_child();

}  // namespace spindrift::app
