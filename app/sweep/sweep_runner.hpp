// Carries out what of a sweep is not done yet.
#pragma once

#include <atomic>
#include <functional>
#include <string>
#include <vector>

#include "app/sweep/sweep_folder.hpp"
#include "app/system/task_pool.hpp"

namespace spindrift::app {

struct SweepRoom {
  int threads = 1;          ///< of all runs together
  int jobs = 0;             ///< runs at once, at most; 0: as many as there are threads
  std::uint64_t bytes = 0;  ///< memory that they may need together
};

struct SweepDone {
  std::vector<std::string> failures;  ///< one for each run; empty: it is done, or was not begun
  std::vector<std::string> comparison_failures;        ///< of runs that are done
  std::size_t simulated = 0, drawn = 0, compared = 0;  ///< tasks done now
  int threads = 1;                                     ///< of each task
};

SweepDone carry_out(const SweepPlan& plan, const SweepFolder& folder, const SweepRoom& room,
                    const std::atomic<bool>& stop,
                    const std::function<void(const PoolStatus&)>& on_change);

}  // namespace spindrift::app
