// Tasks that run beside each other, as many as the machine has room for.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace spindrift::app {

struct Task {
  std::string label;                    ///< what is being done, for people
  std::function<std::string()> run;     ///< does it; returns why it failed, or nothing
  std::uint64_t bytes = 0;              ///< memory that it needs, about
  double seconds = 0;                   ///< that it takes, about, to tell how far all are
  std::vector<std::size_t> after = {};  ///< tasks that must be done before; they stand before it
};

struct TaskResult {
  bool done = false;
  std::string failure;  ///< empty, and not done: it was not begun, or stopped
};

/// How far a pool is.
struct PoolStatus {
  std::size_t finished = 0;
  std::size_t all = 0;
  double part = 0;                   ///< of all work, 0 ... 1, by the tasks' seconds
  std::vector<std::string> running;  ///< labels
};

struct PoolLimits {
  int at_once = 1;          ///< tasks
  std::uint64_t bytes = 0;  ///< memory that the running ones may need together
};

/// Runs all tasks, those that stand first first; one that failed keeps those after it from running,
/// with its failure as theirs, and no others.
/// @param stop when it becomes true, no more are begun; the running ones see to it themselves
/// @param on_change called whenever a task begins or ends, by one thread at a time
std::vector<TaskResult> run_tasks(const std::vector<Task>& tasks, const PoolLimits& limits,
                                  const std::atomic<bool>& stop,
                                  const std::function<void(const PoolStatus&)>& on_change);

}  // namespace spindrift::app
