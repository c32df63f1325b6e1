// The report of a comparison as one HTML file, its pictures and plots in it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <span>

#include "app/comparison.hpp"
#include "app/report.hpp"
#include "render/output/output.hpp"

namespace spindrift::app {
namespace {

std::string base64(std::span<const std::byte> bytes) {
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    unsigned group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? std::to_integer<unsigned>(bytes[i + k]) : 0u);
    for (std::size_t k = 0; k < 4; ++k)
      text += k <= count ? digits[group >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

std::string data_uri(const Image& image) {
  return "data:image/png;base64," + base64(output::encode_png(image));
}

constexpr const char* style = R"(<style>
.pair { display: grid; grid-template-columns: 1fr 1fr; gap: 0.5em; margin-bottom: 2em; }
.pair img { width: 100%; image-rendering: pixelated; }
figure { margin: 0; }
figcaption { font-size: 13px; color: #555; }
.beyond { color: #a00; }
.scale { display: inline-block; width: 16em; height: 0.9em; vertical-align: middle; }
</style>
)";

/// Every figure to blink shows the other picture of its pair twice a second.
constexpr const char* blink = R"(<script>
let odd = false;
const show = () => {
  for (const pair of document.querySelectorAll(".pair"))
    pair.querySelector(".blink").src = pair.querySelector(odd ? ".b" : ".a").src;
  odd = !odd;
};
show();
setInterval(show, 500);
</script>
)";

std::string scale_html() {
  std::string colors;
  for (int k = 0; k <= 16; ++k) {
    const Image color = compare::magma({static_cast<float>(k) / 16}, 1, 1);
    colors += fmt::format(",rgb({})", fmt::join(color.pixels, ","));
  }
  return fmt::format(
      "<p>FLIP: 0 <span class=\"scale\" style=\"background:linear-gradient(to right{})\"></span> "
      "1</p>\n",
      colors);
}

std::string pair_html(const ComparisonReport& comparison, const ComparedPair& pair) {
  std::string html = fmt::format("<h3>{}</h3>\n", html_escaped(pair.name));
  for (const std::string& limit : pair.broken)
    html += fmt::format("<p class=\"beyond\">{}</p>\n", html_escaped(limit));
  const auto figure = [&](const char* name, const std::string& source, const std::string& caption) {
    html += fmt::format(
        "<figure><img class=\"{}\" alt=\"\" src=\"{}\"><figcaption>{}</figcaption></figure>\n",
        name, source, html_escaped(caption));
  };
  html += "<div class=\"pair\">\n";
  figure("a", pair.shown->a, comparison.a);
  figure("b", pair.shown->b, comparison.b);
  figure("flip", pair.shown->flip, fmt::format("FLIP, mean {:.4f}", pair.metrics.flip.mean));
  figure("blink", "data:,", "one and the other in turn");
  return html + "</div>\n";
}

std::string row_html(const std::string& name, const compare::Metrics& m, bool beyond) {
  std::string html =
      fmt::format("<tr{}><td>{}</td><td>{:.5f}</td>", beyond ? " class=\"failed\"" : "",
                  html_escaped(name), m.flip.mean);
  for (const double percentile : m.flip.percentiles)
    html += fmt::format("<td>{:.4f}</td>", percentile);
  return html + fmt::format("<td>{:.4f}</td><td>{:.5f}</td><td>{:.2f}</td><td>{:.3f}</td></tr>\n",
                            m.flip.max, m.ssim, m.psnr, 100 * m.changed);
}

std::string table_html(const ComparisonReport& comparison) {
  std::string html = "<table>\n<tr><th></th><th>FLIP, mean</th>";
  for (const int percent : compare::flip_percentiles)
    html += fmt::format("<th>{} %</th>", percent);
  html += fmt::format("<th>largest</th><th>SSIM</th><th>PSNR, dB</th><th>changed, %</th></tr>\n{}",
                      row_html("all", comparison.all.metrics(), false));
  for (const ComparedPair& pair : comparison.pairs)
    html += row_html(pair.name, pair.metrics, !pair.broken.empty());
  return html + "</table>\n<p>Percentages in the head are percentiles of FLIP over the pixels. " +
         fmt::format("A pixel has changed where a channel is off by more than {} of 255.</p>\n",
                     comparison.threshold);
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
  return {data_uri(a), data_uri(b), data_uri(compare::magma(flip, a.width, a.height))};
}

std::string comparison_html(const ComparisonReport& comparison,
                            const std::function<std::string(const Plot&)>& draw) {
  const std::size_t count = comparison.pairs.size(), broken = comparison.broken_pairs();
  std::string html = html_head(comparison.title) + style;
  html += fmt::format("<p>{} and {}</p>\n", html_escaped(comparison.a), html_escaped(comparison.b));
  if (broken > 0)
    html += fmt::format("<p class=\"beyond\">{} of {} pairs beyond a limit.</p>\n", broken, count);
  else if (count > 0)
    html += fmt::format("<p>{} pair{}, none beyond a limit.</p>\n", count, count == 1 ? "" : "s");
  for (const std::string& sentence : comparison.not_compared)
    html += fmt::format("<p class=\"beyond\">{}</p>\n", html_escaped(sentence));
  for (const std::string& note : comparison.notes)
    html += fmt::format("<p>{}</p>\n", html_escaped(note));
  if (comparison.frames && count > 1)
    html += draw(flip_plot(comparison));
  html += scale_html();
  for (const ComparedPair& pair : comparison.pairs)
    if (pair.shown)
      html += pair_html(comparison, pair);
  if (count > 0)
    html += table_html(comparison);
  return html + blink + html_end;
}

}  // namespace spindrift::app
