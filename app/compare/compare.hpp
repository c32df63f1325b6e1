// The command `compare`, which compares pictures, videos or runs.
#pragma once

#include <filesystem>

#include "app/compare/comparison.hpp"
#include "app/errors/errors.hpp"

namespace spindrift::app {

struct CompareOptions {
  std::filesystem::path a, b;                    ///< pictures, folders, videos or runs
  std::filesystem::path output = "out/compare";  ///< folder of the report and the differences
  Limits limits;                                 ///< limits that every pair must keep
  int threshold = compare::default_threshold;    ///< a pixel has changed if a channel, 0 ... 255,
                                                 ///< differs by more
  int shown_pairs = 4;                           ///< number of pairs shown in the report
  bool quiet = false;                            ///< print nothing but errors
  bool json = false;                             ///< print results as JSON
};

/// Compares two pictures, folders, videos or runs, and writes compare.html, compare.json and
/// pictures of the differences into the output folder.
/// @return the exit code, check_failed where a pair is beyond a limit
/// @throws InputError for input that can't be read or doesn't match
int run_compare(const CompareOptions& options);

}  // namespace spindrift::app
