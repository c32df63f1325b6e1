#include "app/bench/bench_measure.hpp"

#include <fmt/format.h>
#include <omp.h>
#include <sys/prctl.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <iostream>
#include <iterator>
#include <new>
#include <stdexcept>
#include <system_error>

#include "app/bench/bench.hpp"
#include "app/checks/estimate.hpp"
#include "app/errors/errors.hpp"
#include "app/run/render.hpp"
#include "app/system/machine_limits.hpp"
#include "app/system/process.hpp"
#include "app/system/threads.hpp"
#include "sim/run/simulation.hpp"

namespace spindrift::app {
namespace {

// A signal handler can reach nothing else than a global variable.
std::atomic<bool> out_of_time{false};  // NOLINT(cppcoreguidelines-avoid-non-const-global-variables)

/// Sets `out_of_time` after some wall-clock time, s, if it still lives then.
class TimeLimit {
 public:
  explicit TimeLimit(double seconds) {
    out_of_time = false;
    std::signal(SIGALRM, [](int) { out_of_time = true; });
    const auto whole = static_cast<long>(seconds);
    const itimerval after{{0, 0}, {whole, static_cast<long>(1e6 * (seconds - double(whole)))}};
    ::setitimer(ITIMER_REAL, &after, nullptr);
  }
  ~TimeLimit() {
    const itimerval never{};
    ::setitimer(ITIMER_REAL, &never, nullptr);
  }
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;
};

void require_finite(const sim::FrameStatistics& s) {
  for (const double value :
       {s.mean_compression, s.max_compression, s.max_speed, s.kinetic_energy, s.potential_energy})
    if (!std::isfinite(value))
      throw std::runtime_error("positions or velocities are not finite");
}

/// Adds the statistics of one frame to a measurement.
/// @param given_energy energy, J, that the liquid has been given: that at the start, that of
/// particles that have come in less that of particles that have left, and the work of moving
/// obstacles
void add_frame(const sim::FrameStatistics& s, double given_energy, Measurement& m) {
  require_finite(s);
  m.steps += s.steps;
  m.rejected_steps += s.rejected_steps;
  m.iterations += s.iterations;
  m.mean_compression = std::max(m.mean_compression, s.mean_compression);
  m.max_compression = std::max(m.max_compression, s.max_compression);
  m.max_speed = std::max(m.max_speed, s.max_speed);
  if (given_energy > 0)
    m.energy_ratio =
        std::max(m.energy_ratio, (s.kinetic_energy + s.potential_energy) / given_energy);
}

/// Simulates a run once, frame by frame, from the start to the scene's full duration.
void simulate_once(const BenchRun& run, Measurement& m) {
  using Clock = std::chrono::steady_clock;
  const VideoConfig& video = run.scene.video;
  sim::Simulation simulation(run.scene.simulation);
  m.boundary_particles = simulation.figures().boundary_particles;
  const sim::FrameStatistics start = simulation.advance_to(0);
  double given_energy = start.kinetic_energy + start.potential_energy;
  for (int frame = 1; frame <= video.frame_count(); ++frame) {
    const Clock::time_point before = Clock::now();
    const auto statistics =
        simulation.advance_to(video.frames_per_second.time_of(frame), &out_of_time);
    if (out_of_time)
      throw std::runtime_error(fmt::format("not done within {:g} s", run.limit_seconds));
    const std::chrono::duration<double> spent = Clock::now() - before;
    const sim::RunFigures figures = simulation.figures();
    m.particles = std::max(m.particles, figures.particles);
    m.simulation_bytes = std::max<std::uint64_t>(m.simulation_bytes, figures.memory_bytes);
    given_energy += statistics.exchange.energy_in - statistics.exchange.energy_out;
    given_energy += std::max(0., statistics.wall_work);
    if (frame <= run.warm_up_frames)
      continue;
    add_frame(statistics, given_energy, m);
    m.wall_seconds += spent.count();
    m.simulated_seconds += video.frames_per_second.time_of(1);
  }
}

nlohmann::ordered_json run_to_json(const BenchRun& run) {
  return {{"scene", to_json(run.scene)},    {"scene_file", run.scene_file.string()},
          {"threads", run.threads},         {"warm_up_frames", run.warm_up_frames},
          {"repetitions", run.repetitions}, {"limit_seconds", run.limit_seconds}};
}

BenchRun run_from_json(const nlohmann::ordered_json& json) {
  const std::filesystem::path file = json.at("scene_file").get<std::string>();
  return {.scene = parse_scene(json.at("scene").dump(), file),
          .scene_file = file,
          .threads = json.at("threads"),
          .warm_up_frames = json.at("warm_up_frames"),
          .repetitions = json.at("repetitions"),
          .limit_seconds = json.at("limit_seconds")};
}

/// The reason not to begin a run that needs more memory than is free, or empty. A machine that runs
/// out of memory may end other programs.
std::string lack_of_memory(const BenchRun& run) {
  const double needed = estimate(run.scene, run.threads).bytes;
  const auto free = static_cast<double>(free_memory());
  return needed > free ? fmt::format("needs about {} of memory, {} are free", bytes_text(needed),
                                     bytes_text(free))
                       : std::string();
}

}  // namespace

Measurement measure(const BenchRun& run) {
  omp_set_num_threads(run.threads);
  const TimeLimit limit(run.limit_seconds);
  Measurement m;
  try {
    require_threads(run.threads - 1);
    for (int k = 0; k < run.repetitions; ++k)
      simulate_once(run, m);
  } catch (const std::bad_alloc&) {
    m.failure = "out of memory";
  } catch (const std::exception& error) {
    m.failure = error.what();
  }
  m.peak_bytes = peak_memory();
  return m;
}

Measurement measure_apart(const BenchRun& run, const std::atomic<bool>& stop) {
  Measurement m;
  m.failure = lack_of_memory(run);
  if (!m.failure.empty())
    return m;
  const ProcessResult child =
      run_process({"/proc/self/exe", "bench-run"}, run_to_json(run).dump(), stop);
  const auto answer = nlohmann::json::parse(child.out, nullptr, false);
  if (child.exit_code == done && !answer.is_discarded())
    return answer.get<Measurement>();
  m.failure = child.err.empty() ? fmt::format("the simulation ended with code {}", child.exit_code)
                                : child.err.substr(0, child.err.find('\n'));
  return m;
}

int run_bench_child() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // a benchmark that is ended leaves no process behind
  const std::string text{std::istreambuf_iterator<char>(std::cin), {}};
  const Measurement m = measure(run_from_json(nlohmann::ordered_json::parse(text)));
  fmt::print("{}\n", nlohmann::json(m).dump());
  return done;
}

}  // namespace spindrift::app
