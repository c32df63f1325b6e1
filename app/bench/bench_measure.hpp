// One simulation, timed, with its errors.
#pragma once

#include <atomic>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "app/bench/bench_runs.hpp"

namespace spindrift::app {

/// What a run gave. A run that did not reach its end has what was measured until then.
struct Measurement {
  std::string failure;  ///< why the run did not reach its end; empty: it did
  std::uint64_t particles = 0;
  std::uint64_t boundary_particles = 0;
  std::uint64_t simulation_bytes = 0;  ///< of the simulation's own arrays
  std::uint64_t peak_bytes = 0;        ///< largest resident size of the whole process
  double simulated_seconds = 0;        ///< of all repetitions, without warming up
  double wall_seconds = 0;  ///< for those, the measurement of every frame's errors included
  std::int64_t steps = 0;
  std::int64_t rejected_steps = 0;
  std::int64_t iterations = 0;
  double mean_compression = 0;  ///< of the worst frame, as in sim::FrameStatistics
  double max_compression = 0;   ///< of all frames
  double energy_ratio = 0;      ///< largest energy over that at the start; 0: none at the start
  double max_speed = 0;         ///< m/s
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Measurement, failure, particles, boundary_particles,
                                   simulation_bytes, peak_bytes, simulated_seconds, wall_seconds,
                                   steps, rejected_steps, iterations, mean_compression,
                                   max_compression, energy_ratio, max_speed)

/// Simulates a run in this process.
Measurement measure(const BenchRun& run);

/// The same in a process of its own, this program run again, so that its peak memory is that of
/// this run alone, and neither a crash nor a lack of memory ends the benchmark. @param stop ends
/// the run early
Measurement measure_apart(const BenchRun& run, const std::atomic<bool>& stop);

}  // namespace spindrift::app
