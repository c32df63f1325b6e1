// The smaller commands of the program, one function each. All functions return the exit code.
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
  std::vector<std::filesystem::path> folders;  ///< folders of runs, or folders above them
  bool remove = false;                         ///< remove the simulations rather than list them
  bool unused = false;    ///< only simulations other than that of the results in the run's folder
  double older_than = 0;  ///< only simulations whose last frame was written so long ago, s
  bool quiet = false;     ///< print nothing but errors
  bool json = false;      ///< print results as JSON
};

/// Lists the cached simulations of all runs in the folders and below them, or removes them.
/// @return run_failed where one could not be removed
/// @throws InputError for a folder that does not exist
int run_cache(const CacheOptions& options);

/// Prints the scene with all defaults filled in, its warnings, and its estimated particles, memory,
/// disk space and time with so many threads.
int run_check(const Scene& scene, int threads, bool quiet, bool json);

/// Prints versions, processor, renderer and encoder.
int run_info(bool json);

/// Prints the JSON schema of scene files, or of sweep files.
int run_schema(bool of_sweeps);

}  // namespace spindrift::app
