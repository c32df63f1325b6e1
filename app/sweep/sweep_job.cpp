#include "app/sweep/sweep_job.hpp"

#include <fmt/format.h>
#include <omp.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <mutex>
#include <thread>

#include "app/errors/errors.hpp"
#include "app/files/folder_lock.hpp"
#include "app/run/render.hpp"
#include "app/sweep/sweep.hpp"
#include "app/system/process.hpp"
#include "app/system/threads.hpp"
#include "render/compare/metrics.hpp"
#include "render/output/atomic_file.hpp"
#include "render/output/output.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

/// Keeps in a file for how many seconds something has been at work, in all its sittings. The file
/// is up to date to half a second even where the process is killed.
class Stopwatch {
 public:
  explicit Stopwatch(fs::path file) : file_(std::move(file)) {
    std::ifstream(file_) >> before_;
    thread_ = started_thread([this] { run(); });
  }
  ~Stopwatch() {
    {
      const std::lock_guard lock(mutex_);
      ended_ = true;
    }
    end_.notify_one();
    thread_.join();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  void run() {
    std::unique_lock lock(mutex_);
    while (!end_.wait_for(lock, std::chrono::milliseconds(500), [this] { return ended_; }))
      write();
    write();
  }

  void write() {
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start_;
    output::write_file(file_, fmt::format("{:.3f}\n", before_ + spent.count()));
  }

  fs::path file_;
  double before_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::mutex mutex_;
  std::condition_variable end_;
  bool ended_ = false;
  std::thread thread_;
};

Json render_job(const SweepPlan& plan, const SweepRun& run, int threads, const fs::path& output) {
  return {{"parent", ::getpid()},
          {"threads", threads},
          {"output", output.string()},
          {"scene_file", fs::absolute(plan.scene_file).string()},
          {"scene", to_json(run.scene)}};
}

Scene scene_of(const Json& job) {
  return parse_scene(job.at("scene").dump(), job.at("scene_file").get<std::string>());
}

RenderOptions options_of(const Json& job) {
  RenderOptions options;
  options.output = job.at("output").get<std::string>();
  options.threads = job.at("threads");
  options.scene_file = job.at("scene_file").get<std::string>();
  options.replace = true;  // the folder may hold results of the sweep as it was before
  options.quiet = true;
  return options;
}

int simulate(const Json& job, const FolderLock& lock) {
  Scene scene = scene_of(job);
  if (scene.probes_rate == 0)
    scene.probes.clear();  // each run reads its own probes from the cached frames
  RenderOptions options = options_of(job);
  options.simulate_only = true;
  const Stopwatch stopwatch(options.output / seconds_file);
  return run_render(scene, options, lock);
}

int draw(const Json& job, const FolderLock& lock) {
  RenderOptions options = options_of(job);
  options.from_particles = job.at("particles").get<std::string>();
  return run_render(scene_of(job), options, lock);
}

int compare_runs(const Json& job) {
  const fs::path a = job.at("a").get<std::string>(), b = job.at("b").get<std::string>();
  const fs::path output = job.at("output").get<std::string>();
  const Json& of = job.at("of");
  fs::remove(output / differences_file);  // it is about the pictures as they were
  compare::Tally all;
  Json frames = Json::array();
  for (const int number : of.at("frames")) {
    const std::string name = fmt::format("{:04}.png", number);
    const Image first = output::read_png(a / "frames" / name);
    const compare::Comparison found =
        compare::compare(first, output::read_png(b / "frames" / name));
    all.add(found.tally);
    frames.push_back({{"frame", number}, {"flip", found.tally.metrics().flip.mean}});
    for (const int picture : of.at("pictures"))
      if (picture == number)
        output::write_png(output / name, compare::magma(found.flip, first.width, first.height));
  }
  const compare::Metrics m = all.metrics();
  const Json report{{"flip", m.flip.mean},  {"flip_max", m.flip.max}, {"ssim", m.ssim},
                    {"changed", m.changed}, {"frames", frames},       {"of", of}};
  output::write_file(output / differences_file, report.dump(1) + "\n");
  return done;
}

/// Why a child process failed: the first line of what it wrote to standard error, or else how it
/// ended.
std::string complaint(const ProcessResult& child) {
  constexpr std::string_view prefix = "spindrift: ";
  std::string line = child.err.substr(0, child.err.find('\n'));
  if (line.starts_with(prefix))
    line.erase(0, prefix.size());
  if (!line.empty() && child.exit_code < 128)
    return line;
  return child.exit_code >= 128
             ? fmt::format("the program was ended by signal {} ({})", child.exit_code - 128,
                           ::strsignal(child.exit_code - 128))
             : fmt::format("the program ended with code {}", child.exit_code);
}

}  // namespace

Json simulate_job(const SweepPlan& plan, const SweepFolder& folder, const SweepRun& run,
                  int threads) {
  Json job = render_job(plan, run, threads, folder.simulation(run));
  job["do"] = "simulate";
  return job;
}

Json draw_job(const SweepPlan& plan, const SweepFolder& folder, const SweepRun& run, int threads) {
  Json job = render_job(plan, run, threads, folder.run(run));
  job["do"] = "draw";
  job["particles"] = folder.particles(run).string();
  return job;
}

Json compare_job(const SweepPlan& plan, const SweepFolder& folder, const SweepPair& pair,
                 int threads) {
  const SweepRun &a = plan.runs[pair.a], &b = plan.runs[pair.b];
  return {{"do", "compare"},
          {"parent", ::getpid()},
          {"threads", threads},
          {"output", folder.difference(a, b).string()},
          {"a", folder.run(a).string()},
          {"b", folder.run(b).string()},
          {"of", comparison_of(plan, pair)}};
}

std::string do_apart(const Json& job, const std::atomic<bool>& stop) {
  output::make_folders(job.at("output").get<std::string>());
  const ProcessResult child = run_process({"/proc/self/exe", "sweep-job"}, job.dump(), stop);
  return child.exit_code == done ? std::string() : complaint(child);
}

int run_sweep_job() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // no child outlives its sweep
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const Json job = Json::parse(text);
  if (::getppid() != job.at("parent").get<int>())
    return run_failed;  // the sweep ended before prctl was called
  const int threads = job.at("threads");
  omp_set_num_threads(threads);
  // Mesa's software renderer reads this.
  ::setenv("LP_NUM_THREADS", std::to_string(threads).c_str(), 0);
  const fs::path output = job.at("output").get<std::string>();
  const FolderLock lock(output, true);
  require_threads(threads_of_run(threads));
  const auto what = job.at("do").get<std::string>();
  return what == "simulate" ? simulate(job, lock)
         : what == "draw"   ? draw(job, lock)
                            : compare_runs(job);
}

}  // namespace spindrift::app
