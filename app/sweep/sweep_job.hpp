// The jobs that a sweep gives to child processes, as JSON. run_sweep_job() in sweep.hpp does one in
// the child.
#pragma once

#include <atomic>

#include "app/sweep/sweep_folder.hpp"

namespace spindrift::app {

/// The job to simulate the scene of a run, for all runs that share the simulation.
/// @param run the one of them with the longest video
/// @param threads the number of threads that the job may use
Json simulate_job(const SweepPlan& plan, const SweepFolder& folder, const SweepRun& run,
                  int threads);

/// The job to draw a run from its simulation's particles.
Json draw_job(const SweepPlan& plan, const SweepFolder& folder, const SweepRun& run, int threads);

/// The job to make the difference pictures of a pair, and the figures of their difference.
Json compare_job(const SweepPlan& plan, const SweepFolder& folder, const SweepPair& pair,
                 int threads);

/// Does a job in a child process, and waits for its end.
/// @param stop kills the process when it becomes true
/// @return why the job failed; empty where it did not
std::string do_apart(const Json& job, const std::atomic<bool>& stop);

}  // namespace spindrift::app
