// Makes the report of a comparison as one HTML file that contains its pictures and plots.
#include <fmt/format.h>

#include "app/compare/comparison.hpp"
#include "app/pages/compare_page.hpp"
#include "app/pages/plot.hpp"
#include "render/output/output.hpp"

namespace spindrift::app {
namespace {

Url picture_url(const Image& image) {
  const std::vector<std::byte> png = output::encode_png(image);
  return Url::of_content("image/png", {reinterpret_cast<const char*>(png.data()), png.size()});
}

/// A picture, 256 pixels wide and 1 high, of the colours that stand for FLIP from 0 to 1.
Image flip_scale() {
  std::vector<float> values(256);
  for (std::size_t k = 0; k < values.size(); ++k)
    values[k] = static_cast<float>(k) / static_cast<float>(values.size() - 1);
  return compare::magma(values, static_cast<int>(values.size()), 1);
}

/// The sentences above the pictures.
std::vector<PageValues> sentences(const ComparisonReport& comparison) {
  std::vector<PageValues> all;
  const auto add = [&](const std::string& sentence, bool beyond) {
    all.push_back({{"class", beyond ? "beyond" : ""}, {"sentence", sentence}});
  };
  const std::size_t count = comparison.pairs.size(), broken = comparison.broken_pairs();
  if (broken > 0)
    add(fmt::format("{} of {} pairs beyond a limit.", broken, count), true);
  else if (count > 0)
    add(fmt::format("{} pair{}, none beyond a limit.", count, count == 1 ? "" : "s"), false);
  for (const std::string& sentence : comparison.not_compared)
    add(sentence, true);
  for (const std::string& note : comparison.notes)
    add(note, false);
  return all;
}

PageValues pair_values(const ComparedPair& pair) {
  std::vector<PageValues> broken;
  for (const std::string& limit : pair.broken)
    broken.push_back({{"limit", limit}});
  return {{"name", pair.name},
          {"broken", broken},
          {"a_picture", pair.shown->a},
          {"b_picture", pair.shown->b},
          {"flip_picture", pair.shown->flip},
          {"flip_file", Url::of_file(pair.difference)},
          {"flip", fmt::format("{:.4f}", pair.metrics.flip.mean)}};
}

PageValues row_values(const std::string& name, const compare::Metrics& m, bool beyond) {
  std::vector<PageValues> cells;
  const auto add = [&](double value, int digits) {
    cells.push_back({{"cell", fmt::format("{:.{}f}", value, digits)}});
  };
  add(m.flip.mean, 5);
  for (const double percentile : m.flip.percentiles)
    add(percentile, 4);
  add(m.flip.max, 4);
  add(m.ssim, 5);
  add(m.psnr, 2);
  add(100 * m.changed, 3);
  return {{"class", beyond ? "failed" : ""}, {"name", name}, {"cells", cells}};
}

PageValues table_values(const ComparisonReport& comparison) {
  std::vector<PageValues> percentiles, rows;
  for (const int percentile : compare::flip_percentiles)
    percentiles.push_back({{"percentile", std::to_string(percentile)}});
  rows.push_back(row_values("all", comparison.all.metrics(), false));
  for (const ComparedPair& pair : comparison.pairs)
    rows.push_back(row_values(pair.name, pair.metrics, !pair.broken.empty()));
  return {{"percentiles", percentiles},
          {"rows", rows},
          {"threshold", std::to_string(comparison.threshold)}};
}

Plot flip_plot(const ComparisonReport& comparison) {
  Plot plot{.x_label = "picture", .y_label = "FLIP"};
  Curve mean{.title = "mean", .dashed = false}, high{.title = "99 %", .color = 1};
  for (std::size_t k = 0; k < comparison.pairs.size(); ++k) {
    const compare::FlipSummary& flip = comparison.pairs[k].metrics.flip;
    mean.points.emplace_back(static_cast<double>(k), flip.mean);
    high.points.emplace_back(static_cast<double>(k), flip.percentiles.back());
  }
  plot.curves = {mean, high};
  return plot;
}

}  // namespace

ShownPair shown_pair(const Image& a, const Image& b, const std::vector<float>& flip) {
  return {picture_url(a), picture_url(b), picture_url(compare::magma(flip, a.width, a.height))};
}

std::string comparison_html(const ComparisonReport& comparison) {
  std::vector<PageValues> plots, pairs, tables;
  if (comparison.frames && comparison.pairs.size() > 1)
    plots.push_back(plot_values(flip_plot(comparison)));
  for (const ComparedPair& pair : comparison.pairs)
    if (pair.shown)
      pairs.push_back(pair_values(pair));
  if (!comparison.pairs.empty())
    tables.push_back(table_values(comparison));
  return PageTemplate(compare_page)
      .fill({{"title", comparison.title},
             {"a", comparison.a},
             {"b", comparison.b},
             {"sentences", sentences(comparison)},
             {"plots", plots},
             {"scale", picture_url(flip_scale())},
             {"pairs", pairs},
             {"tables", tables}});
}

}  // namespace spindrift::app
