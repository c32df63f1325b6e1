// Plots as SVG pictures, drawn by gnuplot, and the HTML pages they stand in.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace spindrift::app {

enum class Marker { none, circle, square };

struct Curve {
  std::string title = {};  ///< in the key; empty: not there
  std::vector<std::pair<double, double>> points = {};
  int color = 0;  ///< the same number has the same colour
  Marker marker = Marker::none;
  bool filled = false;
  bool line = false;   ///< through the points in their order; always without markers
  bool dashed = true;  ///< how the line is drawn
};

struct Plot {
  std::string x_label = {};
  std::string y_label = {};
  bool log_x = false;
  bool log_y = false;
  bool y_from_zero = true;  ///< else from the lowest point; of no meaning where logarithmic
  std::vector<Curve> curves = {};
};

/// What gnuplot is told. Curves without points are left out; texts must not hold a line's end.
std::string gnuplot_script(const Plot& plot);

/// The plot as an <svg> element. @throws std::runtime_error when gnuplot is missing or fails
std::string draw_svg(const Plot& plot);

/// Draws plots into a report, which is left without them from the first one that fails on.
class PlotDrawer {
 public:
  /// The plot as an <svg> element, or a sentence in its place.
  std::string operator()(const Plot& plot);

  /// Why plots are missing; empty: none is.
  const std::string& failure() const { return failure_; }

 private:
  std::string failure_;
};

/// A page's beginning, up to its title as a heading.
std::string html_head(const std::string& title);
inline constexpr const char* html_end = "</body>\n</html>\n";

/// Text as it stands, within HTML.
std::string html_escaped(const std::string& text);

}  // namespace spindrift::app
