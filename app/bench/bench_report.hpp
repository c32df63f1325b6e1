// Makes the benchmark's report, one HTML page that contains its plots.
#pragma once

#include <string>
#include <vector>

#include "app/bench/bench_table.hpp"
#include "app/pages/plot.hpp"

namespace spindrift::app {

/// The plot of compression over cost for all runs of one scene, with the Pareto front of every
/// particle spacing.
/// @param largest whether to plot the largest compression rather than the mean one
Plot plane_plot(const std::vector<const BenchRow*>& rows, bool largest);

/// The whole page, with a section for each of sections_of(rows).
std::string report_html(const std::vector<BenchRow>& rows);

}  // namespace spindrift::app
