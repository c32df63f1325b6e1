// The command-line options that the commands share which simulate single scenes.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/scene/scene.hpp"

namespace spindrift::app {

/// The shared options as typed.
struct TypedCommon {
  Overrides overrides;  ///< values of --set
  std::string backend;  ///< name of the backend; empty: as the scene says
  int threads = 0;      ///< 0: as many as the machine has
  bool quiet = false;
  bool json = false;
};

/// Adds the options to a command; parsing stores their values in `typed`, which must outlive it.
void add_common_options(CLI::App& command, TypedCommon& typed);

/// The values of --set, and those of options that stand for a --set, such as --backend.
Overrides all_overrides(const TypedCommon& typed);

}  // namespace spindrift::app
