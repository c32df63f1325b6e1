#include "app/sweep/sweep_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "app/checks/estimate.hpp"
#include "app/sweep/sweep_job.hpp"

namespace spindrift::app {
namespace {

// Measured on pictures of 1280x720.
constexpr double bytes_per_compared_pixel = 120;
constexpr double seconds_per_compared_pixel = 4e-7;

enum class TaskKind { simulate, draw, compare };

/// The tasks of a sweep that are not done yet: simulations, then drawings, then comparisons.
class Schedule {
 public:
  Schedule(const SweepPlan& plan, const SweepFolder& folder, const SweepRoom& room,
           const std::atomic<bool>& stop)
      : plan_(plan), folder_(folder), stop_(stop) {
    std::map<std::string, int> simulations;
    for (const SweepRun& run : plan.runs)
      ++simulations[run.simulation];
    const int most = room.jobs > 0 ? std::min(room.jobs, room.threads) : room.threads;
    // All runs have the same number of threads, so that their times can be compared.
    threads_ = room.threads / std::min(most, static_cast<int>(simulations.size()));
    at_once_ = std::min(most, room.threads / threads_);
    add_simulations();
    add_drawings();
    add_comparisons();
  }

  const std::vector<Task>& tasks() const { return tasks_; }
  int at_once() const { return at_once_; }

  SweepDone summary(const std::vector<TaskResult>& results) const {
    SweepDone sum;
    sum.threads = threads_;
    for (std::size_t i = 0; i < results.size(); ++i) {
      const auto& after = tasks_[i].after;
      const bool begun =
          std::all_of(after.begin(), after.end(), [&](std::size_t k) { return results[k].done; });
      if (begun && kinds_[i] == TaskKind::compare && !results[i].failure.empty())
        sum.comparison_failures.push_back(tasks_[i].label + ": " + results[i].failure);
      if (!results[i].done)
        continue;
      (kinds_[i] == TaskKind::simulate ? sum.simulated
       : kinds_[i] == TaskKind::draw   ? sum.drawn
                                       : sum.compared)++;
    }
    for (const std::optional<std::size_t>& task : drawings_)
      sum.failures.push_back(task ? results[*task].failure : "");
    return sum;
  }

 private:
  std::size_t add(TaskKind kind, std::string label, Json job, double bytes, double seconds,
                  std::vector<std::size_t> after) {
    kinds_.push_back(kind);
    tasks_.push_back({.label = std::move(label),
                      .run = [this, job = std::move(job)] { return do_apart(job, stop_); },
                      .bytes = static_cast<std::uint64_t>(bytes),
                      .seconds = seconds,
                      .after = std::move(after)});
    return tasks_.size() - 1;
  }

  /// Adds a task for each simulation that is not done. Of the runs that share it, the one with the
  /// longest video says how far it goes.
  void add_simulations() {
    std::map<std::string, const SweepRun*> longest;
    for (const SweepRun& run : plan_.runs) {
      if (folder_.is_drawn(run))
        continue;
      const SweepRun*& chosen = longest[run.simulation];
      if (!chosen || chosen->scene.video.frame_count() < run.scene.video.frame_count())
        chosen = &run;
    }
    for (const SweepRun& run : plan_.runs) {
      const auto found = longest.find(run.simulation);
      if (found == longest.end() || found->second != &run || folder_.is_simulated(run))
        continue;
      const Estimate cost = estimate(run.scene, threads_);
      simulations_[run.simulation] =
          add(TaskKind::simulate, "simulating " + run.name,
              simulate_job(plan_, folder_, run, threads_), cost.bytes, cost.seconds, {});
    }
  }

  void add_drawings() {
    for (const SweepRun& run : plan_.runs) {
      drawings_.emplace_back();
      if (folder_.is_drawn(run))
        continue;
      std::vector<std::size_t> after;
      if (const auto found = simulations_.find(run.simulation); found != simulations_.end())
        after.push_back(found->second);
      const Estimate cost = estimate(run.scene, threads_);
      drawings_.back() =
          add(TaskKind::draw, "drawing " + run.name, draw_job(plan_, folder_, run, threads_),
              cost.bytes, 0.5 * cost.seconds, std::move(after));
    }
  }

  void add_comparisons() {
    for (const SweepPair& pair : pairs_of(plan_)) {
      if (folder_.is_compared(plan_, pair))
        continue;
      std::vector<std::size_t> after;
      for (const std::size_t number : {pair.a, pair.b})
        if (drawings_[number])
          after.push_back(*drawings_[number]);
      const VideoConfig& video = plan_.runs[pair.a].scene.video;
      const double pixels = static_cast<double>(video.width) * video.height;
      const Json job = compare_job(plan_, folder_, pair, threads_);
      const auto frames = static_cast<double>(job.at("of").at("frames").size());
      add(TaskKind::compare,
          fmt::format("comparing {} and {}", plan_.runs[pair.a].name, plan_.runs[pair.b].name), job,
          pixels * bytes_per_compared_pixel,
          pixels * frames * seconds_per_compared_pixel / threads_, std::move(after));
    }
  }

  const SweepPlan& plan_;
  const SweepFolder& folder_;
  const std::atomic<bool>& stop_;
  int at_once_ = 1, threads_ = 1;
  std::vector<Task> tasks_;
  std::vector<TaskKind> kinds_;
  /// Indices of the tasks that simulate, by the name of the simulation's folder.
  std::map<std::string, std::size_t> simulations_;
  /// Index of the task that draws each run; none where it is drawn already.
  std::vector<std::optional<std::size_t>> drawings_;
};

}  // namespace

SweepDone carry_out(const SweepPlan& plan, const SweepFolder& folder, const SweepRoom& room,
                    const std::atomic<bool>& stop,
                    const std::function<void(const PoolStatus&)>& on_change) {
  const Schedule schedule(plan, folder, room, stop);
  const PoolLimits limits{.at_once = schedule.at_once(), .bytes = room.bytes};
  return schedule.summary(run_tasks(schedule.tasks(), limits, stop, on_change));
}

}  // namespace spindrift::app
