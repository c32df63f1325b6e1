// The command-line options of `compare` and `golden`.
#pragma once

#include <CLI/CLI.hpp>

#include "app/compare/compare.hpp"
#include "app/golden/golden.hpp"

namespace spindrift::app {

/// Adds the options of `compare`; parsing stores their values in `options`, which must outlive it.
void add_compare_options(CLI::App& command, CompareOptions& options);
/// Adds the options of `golden`; parsing stores their values in `options`, which must outlive it.
void add_golden_options(CLI::App& command, GoldenOptions& options);

}  // namespace spindrift::app
