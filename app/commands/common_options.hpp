// What can be typed after the commands that simulate scenes.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "app/scene/scene.hpp"

namespace spindrift::app {

struct TypedCommon {
  Overrides overrides;
  std::string backend;  ///< empty: as the scene says
  int threads = 0;      ///< 0: as many as the machine has
  bool quiet = false;
  bool json = false;
};

void add_common_options(CLI::App& command, TypedCommon& typed);

/// What --set says, and options that stand for it.
Overrides all_overrides(const TypedCommon& typed);

}  // namespace spindrift::app
