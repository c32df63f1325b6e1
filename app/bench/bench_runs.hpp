// What the benchmark runs: the plane of speed against error, and the scaling of its own dam break.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "app/scene/scene.hpp"

namespace spindrift::app {

/// What a run is compared with: the others of its series.
enum class BenchSeries { plane, particles, threads };

/// One simulation to be measured.
struct BenchRun {
  BenchSeries series = BenchSeries::plane;
  Scene scene;
  std::filesystem::path scene_file = {};  ///< from whose folder the paths of meshes start
  int threads = 1;
  int warm_up_frames = 0;      ///< simulated before the measurement begins
  int repetitions = 1;         ///< of the whole simulation; their times and steps are added up
  double limit_seconds = 600;  ///< wall time after which the run is given up
};

/// What is varied. The factors multiply what a scene says.
struct BenchPlan {
  std::vector<std::filesystem::path> scenes;  ///< of the plane; none: the built-in dam break
  Overrides overrides;
  bool plane = true;
  bool particle_scaling = false;
  bool thread_scaling = false;
  std::vector<double> spacing_factors;
  std::vector<double> tolerance_factors;
  std::vector<double> time_step_factors;
  std::vector<sim::SolverType> solvers;
  std::vector<int> particle_counts;  ///< of the scaling over particles, about
  int thread_scaling_particles = 0;  ///< about
  int threads = 1;                   ///< of all runs; the most, in the scaling over threads
  double limit_seconds = 600;        ///< wall time of a run
};

/// The plan that is followed where nothing else is asked for. The quick one is done within three
/// minutes on two cores.
BenchPlan default_plan(bool quick);

/// All runs of a plan, in order. @throws SceneError for a scene that can't be read, or that a
/// factor puts out of range
std::vector<BenchRun> planned_runs(const BenchPlan& plan);

/// About `count` copies of a scene's domain, liquid and obstacles side by side, as one scene in
/// which every other copy is mirrored.
Scene tiled(const Scene& scene, int count);

/// 1, 2, 4 ... and `most` itself.
std::vector<int> thread_counts(int most);

}  // namespace spindrift::app
