// Describes the plots of the HTML reports, which plot.js draws in the browser.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/pages/page.hpp"

namespace spindrift::app {

enum class Marker { none, circle, square };

struct Curve {
  std::string title = {};  ///< shown in the legend; left out of the legend if empty
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

/// The record of a plot in the list {{#plots}} of a page's template: its data, without curves that
/// have no points.
PageValues plot_values(const Plot& plot);

}  // namespace spindrift::app
