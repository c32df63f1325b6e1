// Draws plots for the reports as SVG pictures, with gnuplot.
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/pages/page.hpp"

namespace spindrift::app {

enum class Marker { none, circle, square };

struct Curve {
  std::string title = {};  ///< shown in the key; left out of the key if empty
  std::vector<std::pair<double, double>> points = {};
  int color = 0;  ///< number of one of eight colours; curves with the same number share a colour
  Marker marker = Marker::none;
  bool filled = false;  ///< whether the markers are filled
  bool line = false;    ///< joins the points in their order; curves without markers always do
  bool dashed = true;   ///< whether the line is dashed
};

struct Plot {
  std::string x_label = {};
  std::string y_label = {};
  bool log_x = false;
  bool log_y = false;
  bool y_from_zero = true;  ///< y axis begins at 0, not at the lowest point; ignored with log_y
  std::vector<Curve> curves = {};
};

/// The gnuplot script that draws a plot. Curves without points are left out.
std::string gnuplot_script(const Plot& plot);

/// Draws a plot as an SVG document.
/// @throws std::runtime_error when gnuplot is missing or fails
std::string draw_svg(const Plot& plot);

/// Turns a plot into the record that stands for it in the list {{#plots}} of a page's template.
using DrawPlot = std::function<PageValues(const Plot&)>;

/// The record of a plot that is shown by its picture.
PageValues shown_plot(Url picture, const Plot& plot);
/// The record of a plot in whose place a sentence stands.
PageValues missing_plot(const std::string& sentence);

/// Draws the plots of a report. Once one has failed, all further ones are left out.
class PlotDrawer {
 public:
  /// The plot as a picture within the page (as an image, in which no script runs), or a sentence in
  /// its place.
  PageValues operator()(const Plot& plot);

  /// The reason why plots are missing; empty where none has failed.
  const std::string& failure() const { return failure_; }

 private:
  std::string failure_;
};

}  // namespace spindrift::app
