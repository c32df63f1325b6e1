// Runs one simulation of a benchmark and measures its time, memory and errors.
#pragma once

#include <atomic>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>

#include "app/bench/bench_runs.hpp"

namespace spindrift::app {

/// The results of a run. A run that did not reach its end has what was measured until then.
struct Measurement {
  std::string failure;          ///< why the run did not reach its end; empty where it did
  std::uint64_t particles = 0;  ///< the most liquid particles at any time
  std::uint64_t boundary_particles = 0;
  std::uint64_t simulation_bytes = 0;  ///< size of the simulation's own arrays
  std::uint64_t peak_bytes = 0;        ///< largest resident size of the whole process
  double simulated_seconds = 0;        ///< simulated time of all repetitions, without warm-up
  double wall_seconds = 0;  ///< wall-clock time for that, with the measurement of frames' errors
  std::int64_t steps = 0;
  std::int64_t rejected_steps = 0;  ///< steps that were repeated smaller
  std::int64_t iterations = 0;      ///< pressure iterations of all steps
  double mean_compression = 0;      ///< of the worst frame, as in sim::FrameStatistics
  double max_compression = 0;       ///< largest of all frames
  double energy_ratio = 0;  ///< largest ratio of the liquid's energy to the energy it has been
                            ///< given; 0 where it has been given none
  double max_speed = 0;     ///< m/s
};
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Measurement, failure, particles, boundary_particles,
                                   simulation_bytes, peak_bytes, simulated_seconds, wall_seconds,
                                   steps, rejected_steps, iterations, mean_compression,
                                   max_compression, energy_ratio, max_speed)

/// Measures a run in this process. Errors end up in Measurement::failure.
Measurement measure(const BenchRun& run);

/// Measures a run in another process of this program, so that the peak memory is that of this run
/// alone, and neither a crash nor a lack of memory ends the benchmark.
/// @param stop ends the run early when it becomes true
Measurement measure_apart(const BenchRun& run, const std::atomic<bool>& stop);

}  // namespace spindrift::app
