// What a sweep has done by child processes, and how the children do it.
#pragma once

#include <atomic>

#include "app/sweep/sweep_folder.hpp"

namespace spindrift::app {

/// Simulates one of the runs that share a simulation: the one with the longest video.
Json simulate_job(const SweepPlan& plan, const SweepFolder& folder, const SweepRun& run,
                  int threads);

/// Draws a run from its simulation's particles.
Json draw_job(const SweepPlan& plan, const SweepFolder& folder, const SweepRun& run, int threads);

/// Makes the difference pictures of a pair, and the figures.
Json compare_job(const SweepPlan& plan, const SweepFolder& folder, const SweepPair& pair,
                 int threads);

/// Does a job in a process of its own. @param stop ends it early
/// @return why it failed; empty: it did not
std::string do_apart(const Json& job, const std::atomic<bool>& stop);

}  // namespace spindrift::app
