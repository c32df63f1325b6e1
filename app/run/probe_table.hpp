// The readings that a scene's probes take during a run: the times at which they are due, and their
// forms as a CSV table and as an HTML page.
#pragma once

#include <string>
#include <vector>

#include "app/scene/scene.hpp"

namespace spindrift::app {

/// The values of all probes at one instant.
struct ProbeReading {
  double time = 0;             ///< s
  std::vector<double> values;  ///< one per column of each probe; NaN: nothing to measure
};

/// Reads all probes of a scene from a frame.
ProbeReading read_probes(const Scene& scene, const sim::Frame& frame);

/// The times in (begin, end], s, that are whole multiples of the period 1/rate, from 0 on. A time
/// that differs from `end` by rounding alone is `end` itself.
/// @param rate readings per second, above 0
std::vector<double> reading_times(double begin, double end, double rate);

/// The times in (begin, end], s, at which a simulation stops for its probes: as many as there are
/// readings, evenly spread, the last of them `end`. They are the readings' own times where frames
/// are a whole number of readings apart. Elsewhere readings are interpolated between them, since a
/// stop for every frame and for every reading would make many more stops.
std::vector<double> stop_times(double begin, double end, std::size_t readings);

/// The reading at a time, s, interpolated linearly between those at two stops; the later one where
/// the time is that of the later stop. A value is NaN where it is NaN at either stop.
ProbeReading reading_between(const ProbeReading& before, const ProbeReading& after, double time);

/// The readings as CSV: a header with the units, and a line for each reading. A cell is empty where
/// there was nothing to measure.
std::string probes_csv(const Scene& scene, const std::vector<ProbeReading>& readings);

/// The readings as an HTML page with plots over time: for each probe, one for each unit.
std::string probes_html(const Scene& scene, const std::vector<ProbeReading>& readings);

}  // namespace spindrift::app
