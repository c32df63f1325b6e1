// Benchmarks, as a command.
#pragma once

#include <filesystem>

#include "app/bench/bench_runs.hpp"

namespace spindrift::app {

struct BenchOptions {
  BenchPlan plan;
  std::filesystem::path output;  ///< folder of the table and the report
  bool quiet = false;            ///< nothing but errors
  bool json = false;             ///< for machines
};

/// Measures speed, memory and errors over the plan's runs; leaves bench.csv and bench.html.
int run_bench(const BenchOptions& options);

/// One run of a benchmark, in a process of its own: from JSON on the standard input to JSON on the
/// standard output.
int run_bench_child();

}  // namespace spindrift::app
