#include "app/pages/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <system_error>

#include "app/system/process.hpp"

namespace spindrift::app {
namespace {

/// Quotes a text for gnuplot. In single quotes gnuplot takes everything literally but for the
/// quote, which is doubled, and control characters, which become spaces, as a line end would end
/// the command.
std::string quoted_for_gnuplot(const std::string& text) {
  std::string taken;
  for (const char c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
      taken += ' ';
    else
      taken.append(c == '\'' ? 2 : 1, c);
  return fmt::format("'{}'", taken);
}

/// The words with which gnuplot is told how to draw a curve, with its own numbers for the shapes of
/// points.
std::string style(const Curve& curve) {
  static constexpr const char* colors[] = {"#1f77b4", "#d62728", "#2ca02c", "#9467bd",
                                           "#ff7f0e", "#8c564b", "#17becf", "#7f7f7f"};
  const std::string color =
      fmt::format("linecolor rgb '{}'", colors[static_cast<std::size_t>(curve.color) % 8]);
  const int open_shape = curve.marker == Marker::circle ? 6 : 4;
  const std::string points =
      fmt::format("pointtype {} pointsize 0.8", open_shape + (curve.filled ? 1 : 0));
  const int dashes = curve.dashed ? 2 : 1;
  if (curve.marker == Marker::none)
    return fmt::format("with lines dashtype {} {}", dashes, color);
  return curve.line ? fmt::format("with linespoints dashtype {} {} {}", dashes, color, points)
                    : fmt::format("with points {} {}", color, points);
}

}  // namespace

std::string gnuplot_script(const Plot& plot) {
  std::string data, curves;
  for (const Curve& curve : plot.curves) {
    if (curve.points.empty())
      continue;
    const std::string name = fmt::format("$curve{}", &curve - plot.curves.data());
    data += name + " << END\n";
    for (const auto& [x, y] : curve.points)
      data += fmt::format("{:.9g} {:.9g}\n", x, y);
    data += "END\n";
    curves += fmt::format("{} {} {} {}", curves.empty() ? "plot" : ", \\\n ", name, style(curve),
                          curve.title.empty()
                              ? "notitle"
                              : "title " + quoted_for_gnuplot(curve.title) + " noenhanced");
  }
  const char* log_axes = plot.log_x ? (plot.log_y ? "xy" : "x") : (plot.log_y ? "y" : nullptr);
  return "set terminal svg size 600,440 font 'sans-serif,12' background '#ffffff'\n"
         "set grid\nset key above\nset format '%g'\n" +
         (log_axes ? fmt::format("set logscale {}\n", log_axes) : std::string()) +
         (plot.log_x ? "" : "set xrange [0:*]\n") +
         (plot.log_y || !plot.y_from_zero ? "" : "set yrange [0:*]\n") +
         fmt::format("set xlabel {} noenhanced\nset ylabel {} noenhanced\n",
                     quoted_for_gnuplot(plot.x_label), quoted_for_gnuplot(plot.y_label)) +
         data + curves + "\n";
}

std::string draw_svg(const Plot& plot) {
  const std::atomic<bool> never{false};  // drawing takes only a moment and need not be stoppable
  ProcessResult result;
  try {
    result = run_process({"gnuplot"}, gnuplot_script(plot), never);
  } catch (const std::system_error& error) {
    const bool missing = error.code() == std::errc::no_such_file_or_directory;
    throw std::runtime_error(
        fmt::format("gnuplot, which draws the plots, can't be run ({}){}", error.code().message(),
                    missing ? "; on Debian: apt-get install gnuplot-nox" : ""));
  }
  const auto begin = result.out.find("<svg");
  const auto end = result.out.rfind("</svg>");
  if (result.exit_code != 0 || begin == std::string::npos || end == std::string::npos)
    throw std::runtime_error(
        fmt::format("gnuplot failed (code {}): {}", result.exit_code, result.err));
  return result.out.substr(begin, end + 6 - begin);
}

PageValues shown_plot(Url picture, const Plot& plot) {
  return {{"drawn", std::vector<PageValues>{{{"picture", std::move(picture)},
                                             {"label", plot.y_label + " over " + plot.x_label}}}},
          {"missing", std::vector<PageValues>{}}};
}

PageValues missing_plot(const std::string& sentence) {
  return {{"drawn", std::vector<PageValues>{}},
          {"missing", std::vector<PageValues>{{{"sentence", sentence}}}}};
}

PageValues PlotDrawer::operator()(const Plot& plot) {
  if (std::all_of(plot.curves.begin(), plot.curves.end(),
                  [](const Curve& curve) { return curve.points.empty(); }))
    return missing_plot("No plot here: there is nothing in it.");
  try {
    if (failure_.empty())
      return shown_plot(Url::of_content("image/svg+xml", draw_svg(plot)), plot);
  } catch (const std::exception& error) {
    failure_ = error.what();
  }
  return missing_plot("No plot here: it could not be drawn.");
}

}  // namespace spindrift::app
