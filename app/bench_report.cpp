#include "app/bench_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "app/report.hpp"

namespace spindrift::app {
namespace {

using Rows = std::vector<const BenchRow*>;
using Draw = std::function<std::string(const Plot&)>;

std::string table_html(const Rows& rows) {
  const auto columns = shown_columns(rows.front()->run.series);
  std::string html = "<table>\n<tr>";
  for (const ShownColumn& column : columns)
    html += fmt::format("<th>{}</th>", html_escaped(column.title));
  html += "</tr>\n";
  for (const BenchRow* row : rows) {
    const bool front = row->on_mean_front || row->on_max_front;
    html += !row->result.failure.empty() ? "<tr class=\"failed\">"
            : front                      ? "<tr class=\"front\">"
                                         : "<tr>";
    for (const ShownColumn& column : columns)
      html += fmt::format("<td>{}</td>", html_escaped(column.text(*row)));
    html += "</tr>\n";
  }
  return html + "</table>\n";
}

/// One series as a curve. Runs that did not reach their end are left out.
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

std::string plane_html(const Rows& rows, const Draw& draw) {
  return "<p>Every point is a run. Filled ones are on the Pareto front of their spacing (dashed): "
         "none "
         "is both faster and more accurate. Compression is that of the worst frame, measured from "
         "the positions; in the table fronts are in bold.</p>\n" +
         draw(plane_plot(rows, false)) + draw(plane_plot(rows, true)) + table_html(rows);
}

std::string particles_html(const Rows& rows, const Draw& draw) {
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
  return "<p>The built-in dam break, repeated side by side.</p>\n" + draw(time) + draw(memory) +
         table_html(rows);
}

std::string threads_html(const Rows& rows, const Draw& draw) {
  const double one = nanoseconds_per_particle_step(rows.front()->result);
  const Curve measured = curve_of(rows, "measured", threads, [&](const BenchRow& row) {
    return one / nanoseconds_per_particle_step(row.result);
  });
  Curve ideal = curve_of(rows, "ideal", threads, threads);
  ideal.marker = Marker::none;
  ideal.color = 7;
  const Plot plot{.x_label = "threads", .y_label = "speed-up", .curves = {measured, ideal}};
  return "<p>The same liquid on more and more threads.</p>\n" + draw(plot) + table_html(rows);
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

std::string report_html(const std::vector<BenchRow>& rows, const Draw& draw) {
  std::string html =
      html_head("Spindrift benchmark") + fmt::format("<p>{}</p>\n", html_escaped(machine_text()));
  for (const BenchSection& section : sections_of(rows)) {
    html += fmt::format("<h2>{}</h2>\n", html_escaped(section.title));
    html += section.series == BenchSeries::plane       ? plane_html(section.rows, draw)
            : section.series == BenchSeries::particles ? particles_html(section.rows, draw)
                                                       : threads_html(section.rows, draw);
  }
  return html + html_end;
}

}  // namespace spindrift::app
