// What can be typed after the command that measures.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/bench/bench.hpp"
#include "app/commands/common_options.hpp"
#include "app/errors/errors.hpp"

namespace spindrift::app {

/// An empty list: the default one.
struct TypedBench : TypedCommon {
  std::string output;
  std::vector<std::string> scenes;
  std::vector<std::string> solvers;
  std::vector<double> spacing_factors, tolerance_factors, time_step_factors;
  std::vector<int> particle_counts;
  double limit_seconds = BenchPlan{}.limit_seconds;
  bool quick = false;
  bool plane = false, scaling = false, threads_scaling = false;
};

void add_bench_options(CLI::App& command, TypedBench& typed);

/// @throws SceneError, UsageError
int run_typed_bench(const TypedBench& typed);

}  // namespace spindrift::app
