#include "app/bench/bench_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "app/bench/bench_scene.hpp"
#include "app/scene/scene_fields.hpp"
#include "sim/run/simulation.hpp"
#include "sim/start/initial.hpp"

namespace spindrift::app {
namespace {

constexpr const char* built_in_file = "dam_break.json";

Scene built_in_scene(const Overrides& overrides) {
  return parse_scene(bench_scene_text, built_in_file, overrides);
}

/// The override KEY=VALUE for a scene's value times a factor. It has six digits, so that 1.25 times
/// 0.03 is 0.0375 in single precision too.
std::string scaled(std::string_view key, float value, double factor) {
  return fmt::format("{}={:.6g}", key, value * factor);
}

Overrides with(Overrides all, const Overrides& more) {
  all.insert(all.end(), more.begin(), more.end());
  return all;
}

/// The overrides that multiply a solver's compression tolerance by each factor. PCISPH has two
/// tolerances. Basic SPH has its stiffness instead: compression goes with the square of the fastest
/// speed over the speed of sound (Monaghan 2005, section 4), so that the speed of sound is divided
/// by the factor's root. A scene that leaves the speed of sound at 0 has none to vary.
std::vector<Overrides> tolerances(const sim::SolverSettings& solver,
                                  const std::vector<double>& factors) {
  std::vector<Overrides> all;
  for (const double f : factors)
    if (solver.type == sim::SolverType::pcisph)
      all.push_back({scaled("solver.mean_compression", solver.mean_compression, f),
                     scaled("solver.max_compression", solver.max_compression, f)});
    else if (solver.speed_of_sound > 0)
      all.push_back({scaled("solver.speed_of_sound", solver.speed_of_sound, 1 / std::sqrt(f))});
  if (all.empty())
    all.emplace_back();
  return all;
}

/// Appends a run for every combination of the plan's solvers, spacings, tolerances and time steps.
/// @param read reads the scene with given overrides
template <class Read>
void add_plane(const BenchPlan& plan, const std::filesystem::path& file, const Read& read,
               std::vector<BenchRun>& runs) {
  for (const double spacing : plan.spacing_factors)
    for (const sim::SolverType solver : plan.solvers) {
      const auto name = value_names<sim::SolverType>[static_cast<std::size_t>(solver)];
      const Overrides type{fmt::format("solver.type={}", name)};
      const sim::Settings base = read(with(plan.overrides, type)).simulation;
      for (const Overrides& tolerance : tolerances(base.solver, plan.tolerance_factors))
        for (const double step : plan.time_step_factors) {
          const Overrides rest{scaled("fluid.spacing", base.fluid.spacing, spacing),
                               scaled("solver.cfl", base.solver.cfl, step),
                               scaled("solver.max_time_step", base.solver.max_time_step, step)};
          const Overrides all = with(with(with(plan.overrides, type), tolerance), rest);
          runs.push_back({.scene = read(all),
                          .scene_file = file,
                          .threads = plan.threads,
                          .limit_seconds = plan.limit_seconds});
        }
    }
}

using Tile = geometry::Mirror;  ///< maps points of the scene to where a copy of it has them

sim::Shape placed(const sim::Shape& shape, const Tile& tile) {
  if (const auto image = sim::mirrored(shape, tile))
    return *image;
  throw SceneError("scaling runs repeat their scene side by side; meshes can't be repeated");
}

sim::Obstacle placed(const sim::Obstacle& obstacle, const Tile& tile) {
  sim::Obstacle result = obstacle;
  result.shape = placed(obstacle.shape, tile);
  if (!result.motion)
    return result;
  // A mirror reverses translations along its axis, and rotations about the axes that it keeps.
  const glm::vec3 d = tile.direction, angles = d.x * d.y * d.z * d;
  const auto mirror = [&](auto& part) {
    part.translate *= d;
    part.rotate *= angles;
  };
  result.motion->pivot = tile(obstacle.motion->pivot);
  std::for_each(result.motion->keyframes.begin(), result.motion->keyframes.end(), mirror);
  std::for_each(result.motion->oscillations.begin(), result.motion->oscillations.end(), mirror);
  if (result.motion->spin)
    result.motion->spin->axis *= angles;
  return result;
}

/// The scene that the scaling runs repeat. They show what a particle and a step cost as the liquid
/// grows. For that, the work per particle must stay the same: the built-in dam break is repeated
/// side by side at the same spacing, every other copy mirrored. By symmetry the neighbours of a
/// copy act on it as its walls did, so that depth (on which the iterations depend), speeds and time
/// step sizes are the same for every size. Finer particles in the same tank would need shorter
/// steps and more iterations, and hide the cost in question. Copies stand in rows along x and z,
/// and the distance in memory between neighbours grows with them, as in any large scene. The
/// falling columns are measured between 0.05 and 0.1 s, some ten steps, after the first steps have
/// built up the pressure.
Scene scaling_scene(const BenchPlan& plan) {
  const Overrides own{"fluid.spacing=0.0375", "video.frames_per_second=20", "video.duration=0.1"};
  return built_in_scene(with(own, plan.overrides));
}

BenchRun scaling_run(const BenchPlan& plan, const Scene& tile, int particles, int threads) {
  const double tile_particles = static_cast<double>(sim::initial_particle_count(tile.simulation));
  const long count = std::max(1L, std::lround(particles / tile_particles));
  // Small runs are repeated, as their steps take little longer than what disturbs their timing.
  constexpr double enough_particles = 100e3;
  const double all = static_cast<double>(count) * tile_particles;
  return {.scene = tiled(tile, static_cast<int>(count)),
          .scene_file = built_in_file,
          .threads = threads,
          .warm_up_frames = 1,
          .repetitions = static_cast<int>(std::clamp(std::lround(enough_particles / all), 1L, 10L)),
          .limit_seconds = plan.limit_seconds};
}

}  // namespace

BenchPlan default_plan(bool quick) {
  BenchPlan plan;
  plan.solvers = {sim::SolverType::pcisph, sim::SolverType::sph};
  if (quick) {
    plan.spacing_factors = {2, 1.25};
    plan.tolerance_factors = {1, 4};
    plan.time_step_factors = {0.5, 1};
    plan.particle_counts = {10'000, 30'000, 100'000, 300'000};
    plan.thread_scaling_particles = 100'000;
  } else {
    plan.spacing_factors = {2, 1.25, 1};
    plan.tolerance_factors = {0.25, 1, 4};
    plan.time_step_factors = {0.5, 1, 2};
    plan.particle_counts = {10'000, 30'000, 100'000, 300'000, 1'000'000, 2'000'000, 4'000'000};
    plan.thread_scaling_particles = 300'000;
  }
  return plan;
}

std::vector<BenchRun> planned_runs(const BenchPlan& plan) {
  std::vector<BenchRun> runs;
  if (plan.plane && plan.scenes.empty())
    add_plane(plan, built_in_file, built_in_scene, runs);
  if (plan.plane)
    for (const auto& file : plan.scenes)
      add_plane(
          plan, file, [&](const Overrides& all) { return read_scene(file, all); }, runs);
  if (!plan.particle_scaling && !plan.thread_scaling)
    return runs;
  const Scene tile = scaling_scene(plan);
  if (plan.particle_scaling)
    for (const int particles : plan.particle_counts) {
      runs.push_back(scaling_run(plan, tile, particles, plan.threads));
      runs.back().series = BenchSeries::particles;
    }
  if (plan.thread_scaling)
    for (const int threads : thread_counts(plan.threads)) {
      runs.push_back(scaling_run(plan, tile, plan.thread_scaling_particles, threads));
      runs.back().series = BenchSeries::threads;
    }
  return runs;
}

Scene tiled(const Scene& scene, int count) {
  const sim::Settings& one = scene.simulation;
  const glm::vec3 low = one.domain.min, size = one.domain.max - low;
  const int along_x = std::clamp(
      static_cast<int>(std::lround(std::sqrt(double(count) * size.z / size.x))), 1, count);
  const int along_z = static_cast<int>(std::lround(double(count) / along_x));
  Scene result = scene;
  sim::Settings& all = result.simulation;
  all.domain.max = low + size * glm::vec3(along_x, 1, along_z);
  all.fluid.volumes.clear();
  all.obstacles.clear();
  for (int k = 0; k < along_z; ++k)
    for (int i = 0; i < along_x; ++i) {
      const glm::vec3 direction(i % 2 ? -1 : 1, 1, k % 2 ? -1 : 1);
      const glm::vec3 from(i + i % 2, 0, k + k % 2);  // where the copy of `low` lies, in tiles
      const Tile tile{low + from * size - direction * low, direction};
      for (const sim::Volume& volume : one.fluid.volumes)
        all.fluid.volumes.push_back({placed(volume.shape, tile), direction * volume.velocity});
      for (const sim::Obstacle& obstacle : one.obstacles)
        all.obstacles.push_back(placed(obstacle, tile));
    }
  return result;
}

std::vector<int> thread_counts(int most) {
  std::vector<int> counts;
  for (int n = 1; n < most; n *= 2)
    counts.push_back(n);
  counts.push_back(most);
  return counts;
}

}  // namespace spindrift::app
