// Where a sweep's results lie, and which of them are there.
#pragma once

#include <filesystem>

#include "app/files/json_file.hpp"
#include "app/sweep/sweep_plan.hpp"

namespace spindrift::app {

/// Two runs of the plan, set side by side.
struct SweepPair {
  std::size_t a = 0, b = 0;  ///< numbers of the runs
  bool all_frames = false;   ///< compared in every frame, else where pictures are set side by side
};

class SweepFolder {
 public:
  explicit SweepFolder(std::filesystem::path root) : root_(std::move(root)) {}

  const std::filesystem::path& root() const { return root_; }
  /// Of one simulation: the particles, and how long it took.
  std::filesystem::path simulation(const SweepRun& run) const;
  std::filesystem::path particles(const SweepRun& run) const;
  /// Of one run: what the render command leaves.
  std::filesystem::path run(const SweepRun& run) const;
  /// Of one pair: its difference pictures, and differences.json.
  std::filesystem::path difference(const SweepRun& a, const SweepRun& b) const;

  bool is_simulated(const SweepRun& run) const;
  bool is_drawn(const SweepRun& run) const;
  bool is_compared(const SweepPlan& plan, const SweepPair& pair) const;

 private:
  std::filesystem::path root_;
};

/// Wall time that a simulation took, in all its sittings, s; a file in its folder.
inline constexpr const char* seconds_file = "seconds.txt";

/// What a comparison leaves besides its pictures.
inline constexpr const char* differences_file = "differences.json";

/// Number of the frame at a time, or of the last one.
int frame_at(const VideoConfig& video, double time);

/// The pairs whose difference pictures the report shows: all, where the runs are few, else each run
/// with the reference. Only pictures of one size and rate can be compared.
std::vector<SweepPair> pairs_of(const SweepPlan& plan);

/// What a comparison is told, and by which it is told from others: runs, frames, pictures.
Json comparison_of(const SweepPlan& plan, const SweepPair& pair);

}  // namespace spindrift::app
