#include "app/bench/bench_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/pages/bench_page.hpp"
#include "app/run/report.hpp"

namespace spindrift::app {
namespace {

using Rows = std::vector<const BenchRow*>;

/// The values of a section of the page without its plots: its heading, what it is about, and its
/// table.
PageValues section_values(const BenchSection& section, const char* about) {
  const auto shown = shown_columns(section.series);
  std::vector<PageValues> columns, rows;
  for (const ShownColumn& column : shown)
    columns.push_back({{"column", column.title}});
  for (const BenchRow* row : section.rows) {
    std::vector<PageValues> cells;
    for (const ShownColumn& column : shown)
      cells.push_back({{"cell", column.text(*row)}});
    const bool front = row->on_mean_front || row->on_max_front;
    rows.push_back({{"class", !row->result.failure.empty() ? "failed"
                              : front                      ? "front"
                                                           : ""},
                    {"cells", cells}});
  }
  return {{"title", section.title}, {"about", about}, {"columns", columns}, {"rows", rows}};
}

/// The curve of y(row) over x(row). Runs that did not reach their end are left out.
template <class X, class Y>
Curve curve_of(const Rows& rows, const std::string& title, const X& x, const Y& y) {
  Curve curve{.title = title, .marker = Marker::circle, .filled = true, .line = true};
  for (const BenchRow* row : rows)
    if (row->result.failure.empty())
      curve.points.emplace_back(x(*row), y(*row));
  return curve;
}

double particles(const BenchRow& row) {
  return static_cast<double>(row.result.particles);
}
double threads(const BenchRow& row) {
  return row.run.threads;
}

std::vector<Plot> particles_plots(const Rows& rows) {
  const Plot time{.x_label = "particles",
                  .y_label = "ns per particle and step",
                  .log_x = true,
                  .curves = {curve_of(rows, "", particles, [](const BenchRow& row) {
                    return nanoseconds_per_particle_step(row.result);
                  })}};
  const Curve simulation = curve_of(rows, "simulation", particles, [](const BenchRow& row) {
    return bytes_per_particle(row.result);
  });
  Curve process = curve_of(rows, "whole process, at its peak", particles, [](const BenchRow& row) {
    return double(row.result.peak_bytes) / particles(row);
  });
  process.color = 1;
  const Plot memory{.x_label = "particles",
                    .y_label = "bytes per particle",
                    .log_x = true,
                    .curves = {simulation, process}};
  return {time, memory};
}

std::vector<Plot> threads_plots(const Rows& rows) {
  const double one = nanoseconds_per_particle_step(rows.front()->result);
  const Curve measured = curve_of(rows, "measured", threads, [&](const BenchRow& row) {
    return one / nanoseconds_per_particle_step(row.result);
  });
  Curve ideal = curve_of(rows, "ideal", threads, threads);
  ideal.marker = Marker::none;
  ideal.color = 7;
  return {{.x_label = "threads", .y_label = "speed-up", .curves = {measured, ideal}}};
}

std::vector<Plot> plots_of(const BenchSection& section) {
  switch (section.series) {
    case BenchSeries::plane:
      return {plane_plot(section.rows, false), plane_plot(section.rows, true)};
    case BenchSeries::particles:
      return particles_plots(section.rows);
    case BenchSeries::threads:
      return threads_plots(section.rows);
  }
  return {};
}

const char* text_about(BenchSeries series) {
  switch (series) {
    case BenchSeries::plane:
      return "Every point is a run. Filled ones are on the Pareto front of their spacing (dashed): "
             "none is both faster and more accurate. Compression is that of the worst frame, "
             "measured from the positions; in the table fronts are in bold.";
    case BenchSeries::particles:
      return "The built-in dam break, repeated side by side.";
    case BenchSeries::threads:
      return "The same liquid on more and more threads.";
  }
  return "";
}

}  // namespace

Plot plane_plot(const Rows& rows, bool largest) {
  constexpr double least = 1e-6;  // percent; a logarithmic axis has no zero
  Plot plot{.x_label = "wall seconds per simulated second",
            .y_label = fmt::format("{} compression, worst frame (%)", largest ? "largest" : "mean"),
            .log_x = true,
            .log_y = true};
  std::map<float, std::map<sim::SolverType, Rows>> groups;
  for (const BenchRow* row : rows)
    if (row->result.failure.empty())
      groups[row->run.scene.simulation.fluid.spacing][row->run.scene.simulation.solver.type]
          .push_back(row);
  int color = 0;
  for (const auto& [spacing, solvers] : groups) {
    Curve line{.color = color, .line = true};
    for (const auto& [solver, members] : solvers) {
      const Marker marker = solver == sim::SolverType::pcisph ? Marker::circle : Marker::square;
      Curve rest{.color = color, .marker = marker}, front = rest;
      front.filled = true;
      for (const BenchRow* row : members) {
        const Measurement& m = row->result;
        const bool best = largest ? row->on_max_front : row->on_mean_front;
        const double error = 100 * (largest ? m.max_compression : m.mean_compression);
        const std::pair point{wall_per_simulated_second(m), std::max(error, least)};
        (best ? front : rest).points.push_back(point);
        if (best)
          line.points.push_back(point);
      }
      (front.points.empty() ? rest : front).title =
          fmt::format("{}, {:g} m", solver_name(members.front()->run), spacing);
      plot.curves.push_back(rest);
      plot.curves.push_back(front);
    }
    std::sort(line.points.begin(), line.points.end());
    plot.curves.push_back(line);
    ++color;
  }
  return plot;
}

std::string report_html(const std::vector<BenchRow>& rows) {
  std::vector<PageValues> sections;
  for (const BenchSection& section : sections_of(rows)) {
    std::vector<PageValues> plots;
    for (const Plot& plot : plots_of(section))
      plots.push_back(plot_values(plot));
    sections.push_back(section_values(section, text_about(section.series)));
    sections.back().emplace("plots", std::move(plots));
  }
  return PageTemplate(bench_page).fill({{"machine", machine_text()}, {"sections", sections}});
}

}  // namespace spindrift::app
