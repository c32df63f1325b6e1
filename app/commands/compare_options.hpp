// What can be typed after the commands that compare pictures.
#pragma once

#include <CLI/CLI.hpp>

#include "app/compare/compare.hpp"

namespace spindrift::app {

void add_compare_options(CLI::App& command, CompareOptions& options);
void add_golden_options(CLI::App& command, GoldenOptions& options);

}  // namespace spindrift::app
