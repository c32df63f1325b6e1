#include "app/run/probe_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/files/csv.hpp"
#include "app/pages/plot.hpp"
#include "app/pages/probes_page.hpp"
#include "app/scene/scene_fields.hpp"
#include "app/tables/values.hpp"

namespace spindrift::app {
namespace {

using Readings = std::vector<ProbeReading>;

/// A unit as it is shown in plots.
std::string shown_unit(std::string_view unit) {
  return unit == "m3" ? "m³" : std::string(unit);
}

/// The curve of one column over time. Many readings are divided into `most_parts` equal parts, or
/// up to twice as many, and the lowest and the highest of each part are taken, so that peaks stay.
Curve curve_of(const Readings& readings, std::size_t column, const std::string& title) {
  constexpr std::size_t most_parts = 1000;
  Curve curve{.title = title, .dashed = false};
  const std::size_t size = std::max<std::size_t>(1, readings.size() / most_parts);
  const auto value = [&](const ProbeReading& reading) { return reading.values[column]; };
  const auto add = [&](const ProbeReading& reading) {
    curve.points.emplace_back(reading.time, value(reading));
  };
  for (std::size_t begin = 0; begin < readings.size(); begin += size) {
    const ProbeReading *lowest = nullptr, *highest = nullptr;
    for (std::size_t i = begin; i < std::min(begin + size, readings.size()); ++i) {
      if (std::isnan(value(readings[i])))
        continue;
      if (lowest == nullptr || value(readings[i]) < value(*lowest))
        lowest = &readings[i];
      if (highest == nullptr || value(readings[i]) > value(*highest))
        highest = &readings[i];
    }
    if (lowest == nullptr)
      continue;
    add(*std::min(lowest, highest));
    if (lowest != highest)
      add(*std::max(lowest, highest));
  }
  return curve;
}

/// The plots of a probe: one for each group of adjacent columns with the same unit.
/// @param first the index of the probe's first column among those of all probes
std::vector<PageValues> plots_of(const std::vector<sim::ProbeColumn>& columns, std::size_t first,
                                 const Readings& readings) {
  std::vector<Plot> plots;
  std::string_view unit;
  for (std::size_t k = 0; k < columns.size(); ++k) {
    if (columns[k].unit != unit) {
      unit = columns[k].unit;
      plots.push_back({.x_label = "time (s)", .y_label = shown_unit(unit), .y_from_zero = false});
    }
    Curve curve = curve_of(readings, first + k, columns[k].name);
    curve.color = static_cast<int>(plots.back().curves.size());
    plots.back().curves.push_back(std::move(curve));
  }
  std::vector<PageValues> shown;
  for (const Plot& plot : plots)
    shown.push_back(plot_values(plot));
  return shown;
}

}  // namespace

ProbeReading read_probes(const Scene& scene, const sim::Frame& frame) {
  ProbeReading reading{frame.time, {}};
  for (const sim::Probe& probe : scene.probes) {
    const std::vector<double> values = sim::measure(probe, frame, scene.simulation);
    reading.values.insert(reading.values.end(), values.begin(), values.end());
  }
  return reading;
}

std::vector<double> reading_times(double begin, double end, double rate) {
  constexpr double rounding = 1e-6;  // in periods
  std::vector<double> due;
  for (double k = std::max(0., std::floor(begin * rate + rounding) + 1); k <= end * rate + rounding;
       ++k)
    due.push_back(k >= end * rate - rounding ? end : k / rate);
  return due;
}

std::vector<double> stop_times(double begin, double end, std::size_t readings) {
  std::vector<double> stops;
  for (std::size_t k = 1; k < readings; ++k)
    stops.push_back(begin +
                    (end - begin) * (static_cast<double>(k) / static_cast<double>(readings)));
  stops.push_back(end);
  return stops;
}

ProbeReading reading_between(const ProbeReading& before, const ProbeReading& after, double time) {
  constexpr double rounding = 1e-6;  // part of the time between the two stops
  const double part = (time - before.time) / (after.time - before.time);
  ProbeReading reading{time, after.values};
  if (!(part < 1 - rounding))
    return reading;
  for (std::size_t i = 0; i < reading.values.size(); ++i)
    reading.values[i] = before.values[i] + part * (after.values[i] - before.values[i]);
  return reading;
}

std::string probes_csv(const Scene& scene, const Readings& readings) {
  std::vector<std::string> cells{"time_s"};
  for (const sim::Probe& probe : scene.probes)
    for (const sim::ProbeColumn& column : sim::probe_columns(probe))
      cells.push_back(fmt::format("{}_{}", column.name, column.unit));
  std::string text = csv_row(cells);
  for (const ProbeReading& reading : readings) {
    cells = {fmt::format("{:.9g}", reading.time)};
    for (const double value : reading.values)
      cells.push_back(std::isnan(value) ? "" : fmt::format("{:.7g}", value));
    text += csv_row(cells);
  }
  return text;
}

std::string probes_html(const Scene& scene, const Readings& readings) {
  std::vector<PageValues> probes;
  std::size_t first = 0;
  for (const sim::Probe& probe : scene.probes) {
    const auto columns = sim::probe_columns(probe);
    std::string quantity(alternative_names<sim::ProbeQuantity>[probe.quantity.index()]);
    const std::string settings =
        std::visit([](const auto& one) { return json_of(one).dump(); }, probe.quantity);
    if (settings != "{}")
      quantity += " " + settings;
    probes.push_back({{"name", probe.name},
                      {"quantity", quantity},
                      {"plots", plots_of(columns, first, readings)}});
    first += columns.size();
  }
  return PageTemplate(probes_page).fill({{"scene", scene.name}, {"probes", probes}});
}

}  // namespace spindrift::app
