// What can be typed after the command that lists and removes kept simulations.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "app/errors/errors.hpp"

namespace spindrift::app {

struct TypedCache {
  std::vector<std::string> folders;
  bool remove = false;
  bool unused = false;
  std::string older_than;  ///< as in 30d; empty: any age
  bool quiet = false;
  bool json = false;
};

void add_cache_options(CLI::App& command, TypedCache& typed);

/// @throws InputError
int run_typed_cache(const TypedCache& typed);

}  // namespace spindrift::app
