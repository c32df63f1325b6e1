// The output folder of a sweep: where its results lie, and which of them are there.
#pragma once

#include <filesystem>

#include "app/files/json_file.hpp"
#include "app/sweep/sweep_plan.hpp"

namespace spindrift::app {

/// Two runs of a plan that are compared with each other.
struct SweepPair {
  std::size_t a = 0, b = 0;  ///< numbers of the runs in the plan
  bool all_frames = false;   ///< whether all frames are compared, not only those that are shown
};

/// The paths of a sweep's results, by run. A result is there only where it is whole and belongs to
/// the run's scene as it is now.
class SweepFolder {
 public:
  explicit SweepFolder(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }
  /// The folder of the simulation that a run shows: its particles, and how long it took.
  std::filesystem::path simulation(const SweepRun& run) const;
  /// The folder of that simulation's particles.
  std::filesystem::path particles(const SweepRun& run) const;
  /// The folder of a run: what the command `render` leaves.
  std::filesystem::path run(const SweepRun& run) const;
  /// The folder of a pair of runs: its difference pictures, and differences.json.
  std::filesystem::path difference(const SweepRun& a, const SweepRun& b) const;

  /// Whether the particles of all frames of a run are there.
  bool is_simulated(const SweepRun& run) const;
  /// Whether the pictures and the video of a run are there.
  bool is_drawn(const SweepRun& run) const;
  /// Whether the comparison of a pair is there, with the frames and pictures of the plan.
  bool is_compared(const SweepPlan& plan, const SweepPair& pair) const;

 private:
  std::filesystem::path root_;
};

/// The name of the file in a simulation's folder that holds the wall-clock time, s, that it took in
/// all its sittings.
inline constexpr const char* seconds_file = "seconds.txt";

/// The name of the file with the figures of a comparison, in the folder of its difference pictures.
inline constexpr const char* differences_file = "differences.json";

/// The number of a video's frame at a time, s; the last one for times after its end.
int frame_at(const VideoConfig& video, double time);

/// The pairs whose difference pictures the report shows: all pairs where the plan has at most 12
/// runs, else each run with the reference. Runs whose pictures differ in size or in frame rate are
/// left out, since they can't be compared.
std::vector<SweepPair> pairs_of(const SweepPlan& plan);

/// What a comparison depends on: hashes of both videos, the numbers of the frames that are
/// compared, and of those whose difference is drawn. A comparison that is there is valid as long as
/// this stays the same.
Json comparison_of(const SweepPlan& plan, const SweepPair& pair);

}  // namespace spindrift::app
