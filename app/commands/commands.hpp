// The commands, one function each. They return the exit code.
#pragma once

#include <filesystem>
#include <vector>

#include "app/bench/bench.hpp"
#include "app/compare/compare.hpp"
#include "app/errors/errors.hpp"
#include "app/golden/golden.hpp"
#include "app/run/render.hpp"
#include "app/scene/scene.hpp"
#include "app/sweep/sweep.hpp"

namespace spindrift::app {

struct CacheOptions {
  std::vector<std::filesystem::path> folders;  ///< of runs, or above them
  bool remove = false;                         ///< not only list them
  bool unused = false;                         ///< only those that their folder's run does not use
  double older_than = 0;                       ///< only those last used so long ago, s
  bool quiet = false;                          ///< nothing but errors
  bool json = false;                           ///< for machines
};

/// Lists the kept simulations of all runs in the folders and below, or removes them.
int run_cache(const CacheOptions& options);

/// Prints the scene with all defaults filled in, and what it will cost.
int run_check(const Scene& scene, int threads, bool quiet, bool json);

/// Prints versions, processor, renderer and encoder.
int run_info(bool json);

/// Prints the JSON schema of scene files, or of sweep files.
int run_schema(bool of_sweeps);

}  // namespace spindrift::app
