// Pictures held against others: what is accepted, what was found, and the report of it.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/pages/plot.hpp"
#include "render/compare/metrics.hpp"

namespace spindrift::app {

/// What is accepted of each pair of pictures; none: anything.
struct Limits {
  std::optional<double> max_flip = {};     ///< mean of FLIP, 0 ... 1
  std::optional<double> max_changed = {};  ///< share of the pixels, 0 ... 1
  std::optional<double> min_ssim = {};
  std::optional<double> min_psnr = {};  ///< dB
};

/// The limits that a pair is beyond, each as a sentence.
std::vector<std::string> broken_limits(const compare::Metrics& metrics, const Limits& limits);

/// A pair's pictures and their difference as PNG files, held in the page itself.
struct ShownPair {
  Url a, b, flip;
};

ShownPair shown_pair(const Image& a, const Image& b, const std::vector<float>& flip);

struct ComparedPair {
  std::string name;
  compare::Metrics metrics;
  std::vector<std::string> broken;      ///< limits
  std::filesystem::path difference;     ///< picture of FLIP, from the report's folder
  std::optional<ShownPair> shown = {};  ///< in the report
};

struct ComparisonReport {
  std::string title = {};      ///< of the report
  std::string a = {}, b = {};  ///< what was compared, as given
  bool frames = false;         ///< the pairs are in the order of time
  int threshold = compare::default_threshold;
  std::vector<ComparedPair> pairs = {};
  compare::Tally all = {};
  std::vector<std::string> not_compared = {};  ///< pairs that could not be, each as a sentence
  std::vector<std::string> notes = {};         ///< for people to know

  std::size_t broken_pairs() const;
  /// All pairs were compared and are within their limits.
  bool passes() const { return broken_pairs() == 0 && not_compared.empty(); }
  /// By the mean of FLIP.
  const ComparedPair& worst() const;
};

nlohmann::ordered_json comparison_json(const ComparisonReport& comparison);

/// A table for people: a line for all pairs together and one for the worst, and the notes.
std::string comparison_text(const ComparisonReport& comparison);

/// Why it does not pass: a line for each pair that was not compared, and for each of the first few
/// beyond their limits.
std::string broken_text(const ComparisonReport& comparison);

/// The whole page: what it shows needs no other file.
std::string comparison_html(const ComparisonReport& comparison, const DrawPlot& draw);

/// Removes the PNG files of a folder, if there is one: what an earlier comparison left.
void remove_pictures(const std::filesystem::path& folder);

/// Writes `name`.json and `name`.html into the folder.
void write_comparison(const ComparisonReport& comparison, const std::filesystem::path& folder,
                      const std::string& name);

}  // namespace spindrift::app
