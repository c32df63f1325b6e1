// The benchmark's report: one HTML file with its plots in it.
#pragma once

#include <string>
#include <vector>

#include "app/bench/bench_table.hpp"
#include "app/pages/plot.hpp"

namespace spindrift::app {

/// Cost against an error: the runs of one scene's plane, with the front of every spacing.
/// @param largest the largest compression instead of the mean one
Plot plane_plot(const std::vector<const BenchRow*>& rows, bool largest);

/// The whole page.
std::string report_html(const std::vector<BenchRow>& rows, const DrawPlot& draw);

}  // namespace spindrift::app
