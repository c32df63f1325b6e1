// Plots as SVG pictures, drawn by gnuplot.
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
  bool line = false;  ///< dashed, through the points in their order
};

struct Plot {
  std::string x_label = {};
  std::string y_label = {};
  bool log_x = false;
  bool log_y = false;
  std::vector<Curve> curves = {};
};

/// What gnuplot is told. Curves without points are left out; texts must not hold a line's end.
std::string gnuplot_script(const Plot& plot);

/// The plot as an <svg> element. @throws std::runtime_error when gnuplot is missing or fails
std::string draw_svg(const Plot& plot);

}  // namespace spindrift::app
