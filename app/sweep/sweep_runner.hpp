// Carries out the tasks of a sweep that are not done yet, each in a process of its own.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "app/sweep/sweep_folder.hpp"
#include "app/system/task_pool.hpp"

namespace spindrift::app {

/// What a sweep may use of the machine.
struct SweepRoom {
  int threads = 1;          ///< number of threads of all runs together
  int jobs = 0;             ///< most runs at once; 0: as many as there are threads
  std::uint64_t bytes = 0;  ///< memory that the runs may need together
};

/// What came of the tasks of a sweep.
struct SweepDone {
  std::vector<std::string> failures;  ///< why each run failed; empty: it is done, or was not begun
  std::vector<std::string> comparison_failures;        ///< failures of comparisons of done runs
  std::size_t simulated = 0, drawn = 0, compared = 0;  ///< numbers of tasks done now
  int threads = 1;                                     ///< number of threads of each task
};

/// Simulates, draws and compares what of a plan is not in the folder yet. A task that fails does
/// not keep those from being done that do not depend on it.
/// @param stop ends the tasks when it becomes true
/// @param on_change called whenever a task begins or ends, by one thread at a time
/// @throws std::runtime_error when no thread can be started
SweepDone carry_out(const SweepPlan& plan, const SweepFolder& folder, const SweepRoom& room,
                    const std::atomic<bool>& stop,
                    const std::function<void(const PoolStatus&)>& on_change);

}  // namespace spindrift::app
