// The commands, one function each, in a file of its own. They return the exit code.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/bench_runs.hpp"
#include "app/comparison.hpp"
#include "app/errors.hpp"
#include "app/folder_lock.hpp"
#include "app/scene.hpp"
#include "app/sweep_plan.hpp"

namespace spindrift::app {

/// Frame numbers from 0, both ends included.
struct FrameRange {
  int first = 0;
  int last = 0;
};

/// How a run says how far it is.
enum class ProgressKind {
  text,  ///< a line that changes on a terminal; lines now and then elsewhere
  json   ///< a line for machines for each frame
};

struct RenderOptions {
  std::filesystem::path output;                         ///< folder of all results
  std::string scene_file;                               ///< absolute; empty: not known
  std::optional<FrameRange> frames;                     ///< none: all
  std::optional<std::filesystem::path> from_particles;  ///< folder of exported particles to draw
  bool export_meshes = false;
  bool export_particles = false;
  bool replace = false;        ///< also the results of another scene
  bool force = false;          ///< also what may not fit into memory or on the disk
  bool cache = true;           ///< keep particles and use those kept
  bool simulate_only = false;  ///< no meshes, pictures or video
  int threads = 0;             ///< 0: as many as the machine has
  bool quiet = false;          ///< nothing but errors
  bool json = false;           ///< for machines
  ProgressKind progress = ProgressKind::text;
  std::string command_line_hint;  ///< the command as typed, to say how to go on
};

struct BenchOptions {
  BenchPlan plan;
  std::filesystem::path output;  ///< folder of the table and the report
  bool quiet = false;            ///< nothing but errors
  bool json = false;             ///< for machines
};

struct SweepOptions {
  std::filesystem::path output;   ///< folder of all results
  int threads = 1;                ///< of all runs together
  int jobs = 0;                   ///< runs at once, at most; 0: as many as there are threads
  bool quiet = false;             ///< nothing but errors
  bool json = false;              ///< for machines
  std::string command_line_hint;  ///< the command as typed, to say how to go on
};

struct CacheOptions {
  std::vector<std::filesystem::path> folders;  ///< of runs, or above them
  bool remove = false;                         ///< not only list them
  bool unused = false;                         ///< only those that their folder's run does not use
  double older_than = 0;                       ///< only those last used so long ago, s
  bool quiet = false;                          ///< nothing but errors
  bool json = false;                           ///< for machines
};

struct CompareOptions {
  std::filesystem::path a, b;
  std::filesystem::path output = "out/compare";  ///< folder of the report and the differences
  Limits limits;                                 ///< of every pair
  int threshold = compare::default_threshold;    ///< of 255; more is a change
  int shown_pairs = 4;                           ///< in the report
  bool quiet = false;                            ///< nothing but errors
  bool json = false;                             ///< for machines
};

enum class GoldenAction { check, update };

struct GoldenOptions {
  GoldenAction action = GoldenAction::check;
  std::filesystem::path list;                   ///< file
  std::filesystem::path output = "out/golden";  ///< folder of what was rendered, and of the report
  std::vector<std::string> only;                ///< names; empty: all
  Overrides overrides;                          ///< of every scene
  bool quiet = false;                           ///< nothing but errors
  bool json = false;                            ///< for machines
};

/// Simulates a scene, and draws it; leaves its pictures, its video and run.json, the particles and
/// what else the options ask for. One process at a time works in a folder: a second one is refused.
/// @throws InputError, std::runtime_error where nothing has been begun
int run_render(const Scene& scene, const RenderOptions& options);

/// The same, by a caller that holds the folder's lock.
int run_render(const Scene& scene, const RenderOptions& options, const FolderLock& lock);

/// Lists the kept simulations of all runs in the folders and below, or removes them.
int run_cache(const CacheOptions& options);

/// Measures speed, memory and errors over the plan's runs; leaves bench.csv and bench.html.
int run_bench(const BenchOptions& options);

/// One run of a benchmark, in a process of its own: from JSON on the standard input to JSON on the
/// standard output.
int run_bench_child();

/// Runs what of a sweep is not done yet, and leaves a report of all of it.
int run_sweep(const SweepRequest& request, const SweepOptions& options);

/// One task of a sweep, in a process of its own: told by JSON on the standard input.
int run_sweep_job();

/// Compares pictures, folders, videos or runs; leaves compare.html, compare.json and the
/// differences. Fails where a pair is beyond a limit. @throws InputError
int run_compare(const CompareOptions& options);

/// Renders the scenes of a list and holds their frames against the pictures kept (check), or keeps
/// them (update). Fails where one is beyond its tolerance or has no picture. @throws SceneError,
/// InputError
int run_golden(const GoldenOptions& options);

/// Prints the scene with all defaults filled in, and what it will cost.
int run_check(const Scene& scene, int threads, bool quiet, bool json);

/// Prints versions, processor, renderer and encoder.
int run_info(bool json);

/// Prints the JSON schema of scene files, or of sweep files.
int run_schema(bool of_sweeps);

}  // namespace spindrift::app
