// Runs tasks in parallel, as many at once as the machine has room for.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace spindrift::app {

struct Task {
  std::string label;                    ///< says what is being done, for people
  std::function<std::string()> run;     ///< does the task; returns why it failed, or empty text
  std::uint64_t bytes = 0;              ///< approximate memory that the task needs
  double seconds = 0;                   ///< approximate duration, for the progress of the pool
  std::vector<std::size_t> after = {};  ///< indices, less than its own, of tasks to be done first
};

struct TaskResult {
  bool done = false;
  std::string failure;  ///< why the task failed; empty where it is done, not begun or stopped
};

/// The progress of a pool.
struct PoolStatus {
  std::size_t finished = 0;
  std::size_t all = 0;
  double part = 0;                   ///< finished part of the work by the tasks' seconds, 0 ... 1
  std::vector<std::string> running;  ///< labels of the running tasks
};

struct PoolLimits {
  int at_once = 1;          ///< number of tasks that may run at once
  std::uint64_t bytes = 0;  ///< memory that the running tasks may need together
};

/// Runs all tasks, earlier ones first. Tasks that come after a failed task, by their `after`, are
/// not run and get its failure; all others are run.
/// @param stop lets no more tasks begin when it becomes true; running tasks must watch it
/// themselves
/// @param on_change called whenever a task begins or ends, by one thread at a time
/// @return the tasks' results, in the order of the tasks
/// @throws std::runtime_error when not a single thread can be started
std::vector<TaskResult> run_tasks(const std::vector<Task>& tasks, const PoolLimits& limits,
                                  const std::atomic<bool>& stop,
                                  const std::function<void(const PoolStatus&)>& on_change);

}  // namespace spindrift::app
