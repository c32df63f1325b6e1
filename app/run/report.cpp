#include "app/run/report.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <string_view>

#include "app/run/progress.hpp"
#include "app/scene/scene_fields.hpp"
#include "app/tables/values.hpp"
#include "render/output/output.hpp"
#include "sim/boundary/obstacle_motion.hpp"

namespace spindrift::app {
namespace {

/// The largest value of one figure over all frames, at least 0.
double worst(const std::vector<sim::FrameStatistics>& frames,
             double sim::FrameStatistics::*figure) {
  double value = 0;
  for (const auto& f : frames)
    value = std::max(value, f.*figure);
  return value;
}

std::int64_t total(const std::vector<sim::FrameStatistics>& frames, auto figure) {
  std::int64_t sum = 0;
  for (const auto& f : frames)
    sum += f.*figure;
  return sum;
}

sim::Exchange total_exchange(const RunRecord& record) {
  sim::Exchange sum;
  for (const auto& f : record.frames)
    sum += f.exchange;
  return sum;
}

/// Warnings of a density error that is clearly beyond what the scene asks for.
/// @param mean, largest the mean and the largest compression of the worst frame
std::vector<std::string> warnings_of(const Scene& scene, double mean, double largest) {
  // A step that was refused often is allowed more than was asked for.
  constexpr double margin = 1.5;
  // Three times the compression of liquid at a tenth of the speed of sound.
  constexpr double most_of_sph = 0.03;
  const sim::SolverSettings& solver = scene.simulation.solver;
  std::vector<std::string> warnings;
  if (solver.type == sim::SolverType::sph) {
    if (mean > most_of_sph)
      warnings.push_back(fmt::format(
          "the liquid is compressed by {:.1f} % in the mean of the worst frame: "
          "solver.speed_of_sound is too low for its speed and depth; ten times the fastest speed "
          "keeps it near 1 %",
          100 * mean));
    return warnings;
  }
  const auto look = [&](std::string_view what, double found, std::string_view key, double asked) {
    if (found > margin * asked)
      warnings.push_back(
          fmt::format("{} is {:.3g} % in the worst frame, beyond the {:.3g} % of {}: there the "
                      "liquid has less room than it needs",
                      what, 100 * found, 100 * asked, key));
  };
  look("the largest compression", largest, "solver.max_compression", solver.max_compression);
  look("the mean compression", mean, "solver.mean_compression", solver.mean_compression);
  return warnings;
}

nlohmann::ordered_json frames_json(const Scene& scene, const RunRecord& record) {
  const bool moves = sim::any_moves(scene.simulation.obstacles);
  const bool exchanges = scene.simulation.exchanges_particles();
  auto frames = nlohmann::ordered_json::array();
  for (std::size_t k = 0; k < record.frames.size(); ++k) {
    const sim::FrameStatistics& f = record.frames[k];
    frames.push_back({{"frame", k},
                      {"time", record.times[k]},
                      {"steps", f.steps},
                      {"rejected_steps", f.rejected_steps},
                      {"iterations", f.iterations},
                      {"min_time_step", f.min_time_step},
                      {"max_time_step", f.max_time_step},
                      {"mean_compression", f.mean_compression},
                      {"max_compression", f.max_compression},
                      {"max_speed", f.max_speed},
                      {"kinetic_energy", f.kinetic_energy},
                      {"potential_energy", f.potential_energy},
                      {"contacts", f.contacts}});
    if (moves)
      frames.back()["wall_work"] = f.wall_work;
    if (exchanges)
      frames.back().update({{"particles", f.particles},
                            {"entered", f.exchange.entered},
                            {"held_back", f.exchange.held_back},
                            {"drained", f.exchange.drained},
                            {"left", f.exchange.left},
                            {"energy_in", f.exchange.energy_in},
                            {"energy_out", f.exchange.energy_out}});
  }
  return frames;
}

}  // namespace

nlohmann::ordered_json versions_json() {
  return {{"spindrift", SPINDRIFT_VERSION},
          {"compiler", SPINDRIFT_COMPILER},
          {"encoder", output::encoder_info()}};
}

std::string processor_name() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    const auto colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos)
      return line.substr(colon + 2);
  }
  return "unknown";
}

std::string machine_text() {
  return fmt::format("{}, {} threads; Spindrift {}, {}", processor_name(), omp_get_num_procs(),
                     SPINDRIFT_VERSION, SPINDRIFT_COMPILER);
}

nlohmann::ordered_json report_json(const Scene& scene, const RunRecord& record,
                                   const nlohmann::ordered_json& earlier) {
  nlohmann::ordered_json json;
  json["gl"] = {{"renderer", record.gl_renderer},
                {"version", record.gl_version},
                {"device", record.egl_device}};
  json["particles"] = record.particles;
  json["boundary_particles"] = record.simulation.boundary_particles;
  json["simulation_bytes"] = record.simulation.bytes;
  if (record.simulation.backend)
    json["backend"] = json_of(*record.simulation.backend);
  json["first_frame"] = record.first_frame;
  json["frames_wanted"] = record.frames_wanted;
  json["frames_finished"] = record.frames_finished;
  json["frames_simulated"] = record.frames_simulated;
  json["wall_seconds"] = record.wall_seconds;
  json["stage_seconds"] = record.stage_seconds;
  json["simulation_seconds"] = record.simulation.seconds;
  json["simulation_phases"] = json_of(record.simulation.phases);
  auto frames = frames_json(scene, record);
  const auto end = static_cast<std::size_t>(scene.video.frame_count());
  for (std::size_t k = frames.size(); k < std::min(earlier.size(), end); ++k)
    frames.push_back(earlier[k]);
  for (const char* key : {"steps", "rejected_steps", "iterations"})
    json[key] = std::accumulate(frames.begin(), frames.end(), std::int64_t{0},
                                [&](std::int64_t sum, const auto& frame) {
                                  return sum + frame.at(key).template get<std::int64_t>();
                                });
  for (const char* key : {"mean_compression", "max_compression"})
    json[fmt::format("worst_{}", key)] =
        std::accumulate(frames.begin(), frames.end(), 0., [&](double most, const auto& frame) {
          return std::max(most, frame.at(key).template get<double>());
        });
  json["warnings"] = warnings_of(scene, json["worst_mean_compression"].get<double>(),
                                 json["worst_max_compression"].get<double>());
  if (!scene.probes.empty())
    json["probes"] = {{"table", "probes.csv"}, {"report", "probes.html"}};
  json["frames"] = std::move(frames);
  return json;
}

void print_table(const Scene& scene, const RenderOptions& options, const RunRecord& record) {
  const auto steps = total(record.frames, &sim::FrameStatistics::steps);
  const auto iterations = total(record.frames, &sim::FrameStatistics::iterations);
  fmt::print("{}: {} particles, {} of {} frames in {}\n", scene.name, record.particles,
             record.frames_finished, record.frames_wanted, duration_text(record.wall_seconds));
  fmt::print("  {:<12} {:>9} {:>12}\n", "stage", "seconds", "ms a frame");
  for (const auto& [stage, seconds] : record.stage_seconds)
    if (seconds > 0)
      fmt::print("  {:<12} {:>9.2f} {:>12.1f}\n", stage, seconds,
                 1000 * seconds / std::max(1, record.frames_finished));
  fmt::print(
      "  stages overlap; {} of {} frames were simulated now, the rest were kept from before\n",
      record.frames_simulated, record.frames.size());
  fmt::print(
      "  {} steps, {:.2f} pressure iterations a step, {} steps repeated smaller\n", steps,
      static_cast<double>(iterations) / static_cast<double>(std::max<std::int64_t>(1, steps)),
      total(record.frames, &sim::FrameStatistics::rejected_steps));
  const double mean = worst(record.frames, &sim::FrameStatistics::mean_compression),
               largest = worst(record.frames, &sim::FrameStatistics::max_compression);
  fmt::print("  density error, worst frame: mean compression {:.3f} %, largest {:.2f} %\n",
             100 * mean, 100 * largest);
  for (const std::string& warning : warnings_of(scene, mean, largest))
    fmt::print("  warning: {}\n", warning);
  if (scene.simulation.exchanges_particles()) {
    const sim::Exchange e = total_exchange(record);
    fmt::print(
        "  {} particles came out of emitters, {} went into sinks, {} left through open faces\n",
        e.entered, e.drained, e.left);
    if (e.held_back > 0)
      fmt::print(
          "  {} particles did not come out of emitters: there was liquid in their nozzles, which "
          "lie four spacings behind the opening\n",
          e.held_back);
  }
  if (!record.video.empty())
    fmt::print("  {}\n", record.video.string());
  if (!scene.probes.empty())
    fmt::print("  {}\n", (options.output / "probes.html").string());
}

}  // namespace spindrift::app
