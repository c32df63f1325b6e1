// Comparisons of pictures, as a command.
#pragma once

#include <filesystem>

#include "app/compare/comparison.hpp"
#include "app/errors/errors.hpp"

namespace spindrift::app {

struct CompareOptions {
  std::filesystem::path a, b;
  std::filesystem::path output = "out/compare";  ///< folder of the report and the differences
  Limits limits;                                 ///< of every pair
  int threshold = compare::default_threshold;    ///< of 255; more is a change
  int shown_pairs = 4;                           ///< in the report
  bool quiet = false;                            ///< nothing but errors
  bool json = false;                             ///< for machines
};

/// Compares pictures, folders, videos or runs; leaves compare.html, compare.json and the
/// differences. Fails where a pair is beyond a limit. @throws InputError
int run_compare(const CompareOptions& options);

}  // namespace spindrift::app
