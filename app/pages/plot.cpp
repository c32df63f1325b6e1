#include "app/pages/plot.hpp"

#include <array>

namespace spindrift::app {

PageValues plot_values(const Plot& plot) {
  static constexpr std::array markers{"none", "circle", "square"};
  auto curves = nlohmann::ordered_json::array();
  for (const Curve& curve : plot.curves)
    if (!curve.points.empty())
      curves.push_back({{"title", curve.title},
                        {"color", curve.color},
                        {"marker", markers[static_cast<std::size_t>(curve.marker)]},
                        {"filled", curve.filled},
                        {"line", curve.line || curve.marker == Marker::none},
                        {"dashed", curve.dashed},
                        {"points", curve.points}});
  return {{"plot", PageData({{"x_label", plot.x_label},
                             {"y_label", plot.y_label},
                             {"log_x", plot.log_x},
                             {"log_y", plot.log_y},
                             {"y_from_zero", plot.y_from_zero},
                             {"curves", curves}})}};
}

}  // namespace spindrift::app
