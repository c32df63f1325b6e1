// The benchmark's report: one HTML file with its plots in it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/bench_table.hpp"
#include "app/plot.hpp"

namespace spindrift::app {

/// Cost against an error: the runs of one scene's plane, with the front of every spacing.
/// @param largest the largest compression instead of the mean one
Plot plane_plot(const std::vector<const BenchRow*>& rows, bool largest);

/// The whole page. @param draw makes an <svg> element of a plot, or what is to stand in its place
std::string report_html(const std::vector<BenchRow>& rows,
                        const std::function<std::string(const Plot&)>& draw);

}  // namespace spindrift::app
