// The results of comparing pairs of pictures, the limits that they must keep, and the reports about
// them. It is used by the commands `compare` and `golden`.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/pages/page.hpp"
#include "render/compare/metrics.hpp"

namespace spindrift::app {

/// The limits that each pair of pictures must keep. A limit that is absent accepts any value.
struct Limits {
  std::optional<double> max_flip = {};     ///< mean of FLIP, 0 ... 1
  std::optional<double> max_changed = {};  ///< share of the pixels that changed, 0 ... 1
  std::optional<double> min_ssim = {};
  std::optional<double> min_psnr = {};  ///< dB
};

/// A sentence for each limit that a pair does not keep.
std::vector<std::string> broken_limits(const compare::Metrics& metrics, const Limits& limits);

/// The two pictures of a pair and a picture of their FLIP, as PNG data within the page.
struct ShownPair {
  Url a, b, flip;
};

/// @param flip FLIP of every pixel, 0 ... 1
ShownPair shown_pair(const Image& a, const Image& b, const std::vector<float>& flip);

/// One pair of pictures and its result.
struct ComparedPair {
  std::string name;
  compare::Metrics metrics;
  std::vector<std::string> broken;      ///< sentences about the limits that the pair does not keep
  std::filesystem::path difference;     ///< picture of FLIP, relative to the report's folder
  std::optional<ShownPair> shown = {};  ///< pictures for the report; none: the pair is not shown
};

/// The results of all pairs.
struct ComparisonReport {
  std::string title = {};
  std::string a = {}, b = {};                  ///< what was compared, as the user gave it
  bool frames = false;                         ///< the pairs are in the order of time
  int threshold = compare::default_threshold;  ///< see CompareOptions::threshold
  std::vector<ComparedPair> pairs = {};
  compare::Tally all = {};                     ///< sums over all pairs
  std::vector<std::string> not_compared = {};  ///< a sentence for each pair that can't be compared
  std::vector<std::string> notes = {};         ///< further sentences that people should read

  /// The number of pairs that do not keep their limits.
  std::size_t broken_pairs() const;
  /// Whether all pairs were compared and keep their limits.
  bool passes() const { return broken_pairs() == 0 && not_compared.empty(); }
  /// The pair with the largest mean FLIP; there must be at least one pair.
  const ComparedPair& worst() const;
};

nlohmann::ordered_json comparison_json(const ComparisonReport& comparison);

/// The notes, and a table for people with a line for all pairs together and one for the worst.
std::string comparison_text(const ComparisonReport& comparison);

/// The reasons why a comparison does not pass: a line for each pair that was not compared, and one
/// for each of the first ten pairs beyond their limits.
std::string broken_text(const ComparisonReport& comparison);

/// The report as one HTML page that needs no other file to show its pictures and plots.
std::string comparison_html(const ComparisonReport& comparison);

/// Removes the PNG files that an earlier comparison has left in a folder, if there is such a
/// folder.
void remove_pictures(const std::filesystem::path& folder);

/// Writes the report as `name`.json and `name`.html into the folder.
void write_comparison(const ComparisonReport& comparison, const std::filesystem::path& folder,
                      const std::string& name);

}  // namespace spindrift::app
