// Plans the runs of a benchmark: the "plane" of speed against error over varied settings of scenes,
// and the scaling of the built-in dam break over particles and threads.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "app/scene/scene.hpp"

namespace spindrift::app {

/// The part of the benchmark that a run belongs to; it is compared with the other runs of that
/// part.
enum class BenchSeries { plane, particles, threads };

/// One simulation to be measured.
struct BenchRun {
  BenchSeries series = BenchSeries::plane;
  Scene scene;
  std::filesystem::path scene_file = {};  ///< file to whose folder the paths of meshes are relative
  int threads = 1;
  int warm_up_frames = 0;      ///< number of frames simulated before the measurement begins
  int repetitions = 1;         ///< of the whole simulation; their times and steps are added up
  double limit_seconds = 600;  ///< wall-clock time after which the run is given up
};

/// The series to run and the settings to vary. The factors multiply a scene's own values.
struct BenchPlan {
  std::vector<std::filesystem::path> scenes;  ///< scenes of the plane; none: the built-in dam break
  Overrides overrides;                        ///< values to set in all scenes
  bool plane = true;
  bool particle_scaling = false;
  bool thread_scaling = false;
  std::vector<double> spacing_factors;    ///< of the particle spacing
  std::vector<double> tolerance_factors;  ///< of the tolerances of compression
  std::vector<double> time_step_factors;  ///< of the CFL number and the longest time step
  std::vector<sim::SolverType> solvers;
  std::vector<int> particle_counts;  ///< approximate, for the scaling over particles
  int thread_scaling_particles = 0;  ///< approximate number, for the scaling over threads
  int threads = 1;             ///< of each run; the largest number in the scaling over threads
  double limit_seconds = 600;  ///< wall-clock time after which a run is given up
};

/// The plan that is followed where nothing else is asked for. The quick one is done within three
/// minutes on two cores.
BenchPlan default_plan(bool quick);

/// All runs of a plan, in order.
/// @throws SceneError for a scene that can't be read, or a factor that puts a value out of range
std::vector<BenchRun> planned_runs(const BenchPlan& plan);

/// A scene with about `count` copies of a scene's domain, liquid and obstacles side by side in x
/// and z, every other copy mirrored.
/// @throws SceneError for a scene with meshes
Scene tiled(const Scene& scene, int count);

/// The numbers of threads in the scaling over threads: 1, 2, 4 ... and `most` itself.
std::vector<int> thread_counts(int most);

}  // namespace spindrift::app
