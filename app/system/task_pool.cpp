#include "app/system/task_pool.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>

#include "app/system/threads.hpp"

namespace spindrift::app {
namespace {

/// One call of run_tasks: the states of its tasks, and the threads that run them.
class Pool {
 public:
  Pool(const std::vector<Task>& tasks, const PoolLimits& limits, const std::atomic<bool>& stop,
       const std::function<void(const PoolStatus&)>& on_change)
      : tasks_(tasks),
        limits_(limits),
        stop_(stop),
        on_change_(on_change),
        states_(tasks.size(), State::waiting),
        results_(tasks.size()) {}

  std::vector<TaskResult> run() {
    const auto count = std::min(tasks_.size(), static_cast<std::size_t>(limits_.at_once));
    std::vector<std::thread> threads;
    threads.reserve(count);
    try {
      while (threads.size() < count)
        threads.push_back(started_thread([this] { work(); }));
    } catch (const std::runtime_error&) {
      if (threads.empty())
        throw;  // otherwise the threads that were started do all the work
    }
    for (std::thread& thread : threads)
      thread.join();
    return std::move(results_);
  }

 private:
  enum class State { waiting, running, ended };

  void work() {
    std::unique_lock lock(mutex_);
    for (;;) {
      const std::size_t next = stop_ ? tasks_.size() : next_ready();
      if (stop_ || all_begun()) {
        changed_.notify_all();
        return;
      }
      if (next == tasks_.size()) {
        changed_.wait(lock);
        continue;
      }
      begin(next);
      lock.unlock();
      std::string failure = run_one(tasks_[next]);
      lock.lock();
      end(next, std::move(failure));
      changed_.notify_all();
    }
  }

  static std::string run_one(const Task& task) {
    try {
      return task.run();
    } catch (const std::exception& error) {
      return error.what();
    }
  }

  bool all_begun() const {
    return std::find(states_.begin(), states_.end(), State::waiting) == states_.end();
  }

  /// The index of the first task that can begin now, or the number of all tasks if none can. Tasks
  /// before it that never can begin are given up.
  std::size_t next_ready() {
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      if (states_[i] != State::waiting)
        continue;
      give_up_if_hopeless(i);
      const auto& after = tasks_[i].after;
      const bool ready =
          std::all_of(after.begin(), after.end(), [&](std::size_t k) { return results_[k].done; });
      if (states_[i] == State::waiting && ready && bytes_ + tasks_[i].bytes <= limits_.bytes)
        return i;
    }
    return tasks_.size();
  }

  void give_up_if_hopeless(std::size_t i) {
    for (const std::size_t k : tasks_[i].after)
      if (states_[k] == State::ended && !results_[k].done)
        results_[i].failure = results_[k].failure;
    if (tasks_[i].bytes > limits_.bytes)
      results_[i].failure = fmt::format("needs about {:.1f} GB of memory, {:.1f} GB are free",
                                        double(tasks_[i].bytes) / 1e9, double(limits_.bytes) / 1e9);
    if (results_[i].failure.empty())
      return;
    states_[i] = State::ended;
    tell();
  }

  void begin(std::size_t i) {
    states_[i] = State::running;
    bytes_ += tasks_[i].bytes;
    tell();
  }

  void end(std::size_t i, std::string failure) {
    states_[i] = State::ended;
    bytes_ -= tasks_[i].bytes;
    results_[i].done = failure.empty() && !stop_;
    if (!stop_)
      results_[i].failure = std::move(failure);
    tell();
  }

  void tell() const {
    PoolStatus status{.finished = 0, .all = tasks_.size(), .part = 0, .running = {}};
    double ended = 0, all = 0;
    for (std::size_t i = 0; i < tasks_.size(); ++i) {
      all += tasks_[i].seconds;
      if (states_[i] == State::running)
        status.running.push_back(tasks_[i].label);
      if (states_[i] != State::ended)
        continue;
      ++status.finished;
      ended += tasks_[i].seconds;
    }
    status.part = all > 0 ? ended / all : 0;
    on_change_(status);
  }

  const std::vector<Task>& tasks_;
  const PoolLimits& limits_;
  const std::atomic<bool>& stop_;
  const std::function<void(const PoolStatus&)>& on_change_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<State> states_;
  std::vector<TaskResult> results_;
  std::uint64_t bytes_ = 0;  ///< memory that the running tasks need
};

}  // namespace

std::vector<TaskResult> run_tasks(const std::vector<Task>& tasks, const PoolLimits& limits,
                                  const std::atomic<bool>& stop,
                                  const std::function<void(const PoolStatus&)>& on_change) {
  return Pool(tasks, limits, stop, on_change).run();
}

}  // namespace spindrift::app
