#include "app/compare/comparison.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>

#include "app/run/report.hpp"
#include "render/output/atomic_file.hpp"

namespace spindrift::app {
namespace {

using compare::Metrics;

nlohmann::ordered_json metrics_json(const Metrics& m) {
  nlohmann::ordered_json flip{{"mean", m.flip.mean}};
  for (std::size_t k = 0; k < compare::flip_percentiles.size(); ++k)
    flip[fmt::format("p{}", compare::flip_percentiles[k])] = m.flip.percentiles[k];
  flip["max"] = m.flip.max;
  return {{"psnr", m.psnr}, {"ssim", m.ssim}, {"flip", flip}, {"changed", m.changed}};
}

std::string table_text(const ComparisonReport& comparison) {
  const std::size_t count = comparison.pairs.size();
  const ComparedPair& worst = comparison.worst();
  const std::string all = fmt::format("all {} pairs", count);
  const std::size_t width = std::max(all.size(), worst.name.size());
  std::string text = fmt::format("{:<{}} {:>8} {:>8} {:>8} {:>8} {:>8} {:>9} {:>9}\n", "", width,
                                 "FLIP", "95 %", "99 %", "largest", "SSIM", "PSNR, dB", "changed");
  const auto add = [&](const std::string& name, const Metrics& m) {
    text += fmt::format("{:<{}} {:>8.5f} {:>8.4f} {:>8.4f} {:>8.4f} {:>8.5f} {:>9.2f} {:>7.3f} %\n",
                        name, width, m.flip.mean, m.flip.percentiles[3], m.flip.percentiles[4],
                        m.flip.max, m.ssim, m.psnr, 100 * m.changed);
  };
  if (count > 1)
    add(all, comparison.all.metrics());
  add(worst.name, worst.metrics);
  return text;
}

}  // namespace

std::vector<std::string> broken_limits(const Metrics& metrics, const Limits& limits) {
  std::vector<std::string> broken;
  const auto check = [&](const char* what, double found, std::optional<double> limit, bool most,
                         const char* unit = "") {
    if (limit && (most ? found > *limit : found < *limit))
      broken.push_back(fmt::format("{} is {:.4g}{}, {} {:g}{} accepted", what, found, unit,
                                   most ? "at most" : "at least", *limit, unit));
  };
  check("the mean of FLIP", metrics.flip.mean, limits.max_flip, true);
  check("the share of changed pixels", metrics.changed, limits.max_changed, true);
  check("SSIM", metrics.ssim, limits.min_ssim, false);
  check("PSNR", metrics.psnr, limits.min_psnr, false, " dB");
  return broken;
}

std::size_t ComparisonReport::broken_pairs() const {
  return static_cast<std::size_t>(std::count_if(
      pairs.begin(), pairs.end(), [](const ComparedPair& pair) { return !pair.broken.empty(); }));
}

const ComparedPair& ComparisonReport::worst() const {
  return *std::max_element(pairs.begin(), pairs.end(), [](const auto& p, const auto& q) {
    return p.metrics.flip.mean < q.metrics.flip.mean;
  });
}

nlohmann::ordered_json comparison_json(const ComparisonReport& comparison) {
  auto pairs = nlohmann::ordered_json::array();
  for (const ComparedPair& pair : comparison.pairs) {
    pairs.push_back({{"name", pair.name}});
    pairs.back().update(metrics_json(pair.metrics));
    pairs.back()["broken_limits"] = pair.broken;
  }
  return {{"a", comparison.a},
          {"b", comparison.b},
          {"versions", versions_json()},
          {"threshold", comparison.threshold},
          {"within_limits", comparison.passes()},
          {"overall", comparison.pairs.empty() ? nlohmann::ordered_json()
                                               : metrics_json(comparison.all.metrics())},
          {"not_compared", comparison.not_compared},
          {"notes", comparison.notes},
          {"pairs", pairs}};
}

std::string comparison_text(const ComparisonReport& comparison) {
  std::string text;
  if (!comparison.pairs.empty())
    text = table_text(comparison);
  for (const std::string& note : comparison.notes)
    text += note + "\n";
  return text;
}

std::string broken_text(const ComparisonReport& comparison) {
  constexpr std::size_t most_shown = 10;
  std::string text;
  for (const std::string& sentence : comparison.not_compared)
    text += fmt::format("spindrift: {}\n", sentence);
  std::size_t shown = 0;
  for (const ComparedPair& pair : comparison.pairs)
    if (!pair.broken.empty() && shown++ < most_shown)
      text += fmt::format("spindrift: {}: {}\n", pair.name, fmt::join(pair.broken, "; "));
  if (shown > most_shown)
    text += fmt::format("spindrift: and {} more beyond the limits\n", shown - most_shown);
  return text;
}

void remove_pictures(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder))
    return;
  std::vector<std::filesystem::path> pictures;
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.is_regular_file() && entry.path().extension() == ".png")
      pictures.push_back(entry.path());
  for (const std::filesystem::path& picture : pictures)
    std::filesystem::remove(picture);
}

void write_comparison(const ComparisonReport& comparison, const std::filesystem::path& folder,
                      const std::string& name) {
  output::write_file(folder / (name + ".json"), comparison_json(comparison).dump(1) + "\n");
  output::write_file(folder / (name + ".html"), comparison_html(comparison));
}

}  // namespace spindrift::app
