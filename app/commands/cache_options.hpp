// The command-line options of `cache`, which lists and removes the particle caches of runs.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/errors/errors.hpp"

namespace spindrift::app {

/// The options of `cache` as typed.
struct TypedCache {
  std::vector<std::string> folders;  ///< empty: out
  bool remove = false;
  bool unused = false;
  std::string older_than;  ///< an age such as 30d; empty: any age
  bool quiet = false;
  bool json = false;
};

/// Adds the options to a command; parsing stores their values in `typed`, which must outlive it.
void add_cache_options(CLI::App& command, TypedCache& typed);

/// Runs `cache` with the options typed, and returns the exit code.
/// @throws InputError
int run_typed_cache(const TypedCache& typed);

}  // namespace spindrift::app
