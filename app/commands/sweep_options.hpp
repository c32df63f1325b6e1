// What can be typed after the command that runs sweeps.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/sweep/sweep.hpp"

namespace spindrift::app {

struct TypedSweep {
  std::string file;                 ///< a scene or a sweep
  std::vector<std::string> values;  ///< KEY=VALUE,VALUE,...
  std::string output;
  std::string reference;
  std::vector<std::string> targets;  ///< METRIC=NUMBER
  std::vector<double> times;         ///< s
  int threads = 0;
  int jobs = 0;
  bool quiet = false;
  bool json = false;
};

void add_sweep_options(CLI::App& command, TypedSweep& typed);

/// @param hint the command as typed. @throws SceneError
int run_typed_sweep(const TypedSweep& typed, const std::string& hint);

}  // namespace spindrift::app
