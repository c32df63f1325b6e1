// Plots as SVG pictures, drawn by gnuplot.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/pages/page.hpp"

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

/// What gnuplot is told. Curves without points are left out.
std::string gnuplot_script(const Plot& plot);

/// The plot as an SVG document. @throws std::runtime_error when gnuplot is missing or fails
std::string draw_svg(const Plot& plot);

/// Makes of a plot what stands for it on a page.
using DrawPlot = std::function<PageValues(const Plot&)>;

/// A plot's picture on a page, or a sentence in its place: a record of the list that a template's
/// {{#plots}} stands for.
PageValues shown_plot(Url picture, const Plot& plot);
PageValues missing_plot(const std::string& sentence);

/// Draws plots into a report, which is left without them from the first one that fails on.
class PlotDrawer {
 public:
  /// The plot as a picture in the page (where no script in it would run), or a sentence.
  PageValues operator()(const Plot& plot);

  /// Why plots are missing; empty: none is.
  const std::string& failure() const { return failure_; }

 private:
  std::string failure_;
};

}  // namespace spindrift::app
