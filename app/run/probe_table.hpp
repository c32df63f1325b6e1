// What a scene's probes read in the course of a run, as a table and as a report.
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.hpp"

namespace spindrift::app {

/// All probes at one instant.
struct ProbeReading {
  double time = 0;             ///< s
  std::vector<double> values;  ///< one for each column of each probe; NaN: nothing to measure
};

ProbeReading read_probes(const Scene& scene, const sim::Frame& frame);

/// The times in (begin, end], s, that are whole multiples of the period 1/rate, from 0 on. One that
/// is `end` but for rounding is `end`.
/// @param rate readings per second, above 0
std::vector<double> reading_times(double begin, double end, double rate);

/// The times in (begin, end], s, at which a simulation stops for its probes: as many as there are
/// readings, evenly spread, the last of them `end`. They are the readings' own times where frames
/// are a whole number of readings apart; elsewhere frames and readings both would make many more
/// stops.
std::vector<double> stop_times(double begin, double end, std::size_t readings);

/// What was read at the later of two stops or, for a time between them, the value on the straight
/// line; NaN where either is.
ProbeReading reading_between(const ProbeReading& before, const ProbeReading& after, double time);

/// A line for each reading under a header with the units; a cell is empty where there was nothing
/// to measure.
std::string probes_csv(const Scene& scene, const std::vector<ProbeReading>& readings);

/// A page with a plot over time of every probe, one for each unit.
std::string probes_html(const Scene& scene, const std::vector<ProbeReading>& readings);

}  // namespace spindrift::app
