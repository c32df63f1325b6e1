#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "app/errors/error_report.hpp"
#include "app/errors/errors.hpp"
#include "app/files/folder_lock.hpp"
#include "app/run/progress.hpp"
#include "app/sweep/sweep.hpp"
#include "app/sweep/sweep_report.hpp"
#include "app/sweep/sweep_results.hpp"
#include "app/sweep/sweep_runner.hpp"
#include "app/system/interrupt.hpp"
#include "app/system/machine_limits.hpp"
#include "render/output/atomic_file.hpp"

namespace spindrift::app {
namespace {

/// Reports how far a sweep is: by a line that is rewritten on a terminal, by lines now and then
/// where there is none.
class SweepProgress {
 public:
  explicit SweepProgress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO)) {}
  ~SweepProgress() {
    if (!quiet_ && terminal_)
      fmt::print(stderr, "\r\033[K");
  }
  SweepProgress(const SweepProgress&) = delete;
  SweepProgress& operator=(const SweepProgress&) = delete;

  void show(const PoolStatus& status) {
    if (quiet_ || (!terminal_ && !pace_.is_due(status.part)))
      return;
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    const std::string left =
        status.part > 0 ? duration_text(spent.count() / status.part * (1 - status.part)) + " left"
                        : "starting";
    const std::string running = status.running.empty() ? "" : "  " + status.running.front();
    const std::string more =
        status.running.size() < 2 ? "" : fmt::format(" and {} more", status.running.size() - 1);
    fmt::print(stderr, "{}{} of {} tasks  {}{}{}{}", terminal_ ? "\r\033[K" : "", status.finished,
               status.all, left, running, more, terminal_ ? "" : "\n");
    std::fflush(stderr);
  }

 private:
  bool quiet_, terminal_;
  LogPace pace_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

void print_runs(const SweepPlan& plan, const std::vector<SweepResult>& results) {
  std::size_t width = 3;
  for (const SweepRun& run : plan.runs)
    width = std::max(width, run.name.size());
  std::vector<std::string> columns{"simulation_seconds", "steps", "iterations", "mean_compression",
                                   "max_compression"};
  if (plan.reference)
    columns.emplace_back("flip");
  for (const SweepTarget& target : plan.targets)
    if (std::find(columns.begin(), columns.end(), target.key) == columns.end())
      columns.push_back(target.key);
  fmt::print("{:<{}}", "run", width);
  for (const std::string& column : columns)
    fmt::print("  {:>12}", column);
  for (const std::size_t i : ranked(plan, results)) {
    fmt::print("\n{:<{}}", plan.runs[i].name, width);
    for (const std::string& column : columns) {
      const auto found = results[i].figures.find(column);
      const std::string text =
          found == results[i].figures.end() ? "-" : fmt::format("{:.4g}", found->second);
      fmt::print("  {:>{}}", text, std::max<std::size_t>(12, column.size()));
    }
  }
  fmt::print("\n");
}

/// The results as the HTML report needs them: with the curves of the probes.
Json page_json(const Json& results, const std::vector<SweepResult>& all) {
  Json page = results;
  for (std::size_t i = 0; i < all.size(); ++i)
    page["runs"][i]["curves"] = all[i].curves;
  return page;
}

Json write_results(const SweepPlan& plan, const SweepFolder& folder,
                   const std::vector<SweepResult>& results) {
  Json json = results_json(plan, folder, results);
  output::write_file(folder.root() / "sweep.json", json.dump(1) + "\n");
  output::write_file(folder.root() / "sweep.csv", results_csv(plan, results));
  output::write_file(folder.root() / "report.html", sweep_html(page_json(json, results)));
  return json;
}

std::string counted(std::size_t count, const char* what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

int tell_failures(const SweepPlan& plan, const SweepDone& done_now) {
  int code = done;
  for (std::size_t i = 0; i < plan.runs.size(); ++i)
    if (!done_now.failures[i].empty()) {
      fmt::print(stderr, "spindrift: {} failed: {}\n", plan.runs[i].name, done_now.failures[i]);
      code = check_failed;
    }
  for (const std::string& failure : done_now.comparison_failures) {
    fmt::print(stderr, "spindrift: {}\n", failure);
    code = check_failed;
  }
  return code;
}

}  // namespace

int run_sweep(const SweepRequest& request, const SweepOptions& options) {
  const SweepPlan plan = plan_sweep(request);
  check_targets(plan);
  const SweepFolder folder(options.output);
  const FolderLock lock(folder.root(), false);
  const InterruptGuard interrupt;
  SweepDone done_now;
  {
    SweepProgress progress(options.quiet);
    done_now = carry_out(
        plan, folder, {.threads = options.threads, .jobs = options.jobs, .bytes = free_memory()},
        InterruptGuard::requested(), [&](const PoolStatus& status) { progress.show(status); });
  }
  const std::vector<SweepResult> results = read_results(plan, folder, done_now.failures);
  const Json json = write_results(plan, folder, results);
  if (InterruptGuard::requested()) {
    const auto complete = std::count_if(results.begin(), results.end(),
                                        [](const SweepResult& r) { return r.complete; });
    fmt::print(stderr, "spindrift: interrupted after {} of {} runs\n", complete, results.size());
    fmt::print(stderr, "The same command goes on from where it stopped: {}\n",
               options.command_line_hint);
    if (options.json)
      print_error_json(run_failed, "interrupted");
    return run_failed;
  }
  if (options.json) {
    fmt::print("{}\n", json.dump(1));
  } else if (!options.quiet) {
    print_runs(plan, results);
    fmt::print("{}, {} and {} made now\n", counted(done_now.simulated, "simulation"),
               counted(done_now.drawn, "video"), counted(done_now.compared, "comparison"));
    fmt::print("{}\n", (folder.root() / "report.html").string());
  }
  std::fflush(stdout);
  return tell_failures(plan, done_now);
}

}  // namespace spindrift::app
