#include "app/sweep/sweep_folder.hpp"

#include <algorithm>
#include <cmath>

#include "app/cache/particle_cache.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

/// The most runs of which each is compared with each.
constexpr std::size_t few_runs = 12;

/// Whether the pictures of two runs have the same size and frame rate.
bool comparable(const SweepRun& a, const SweepRun& b) {
  const VideoConfig &u = a.scene.video, &v = b.scene.video;
  return u.width == v.width && u.height == v.height && u.frames_per_second == v.frames_per_second;
}

/// A hash of all that a run's video depends on.
std::string video_hash(const SweepRun& run) {
  return text_hash(SPINDRIFT_VERSION + run.simulation + to_json(run.scene).dump());
}

}  // namespace

fs::path SweepFolder::simulation(const SweepRun& run) const {
  return root_ / "simulations" / run.simulation;
}

fs::path SweepFolder::particles(const SweepRun& run) const {
  return simulation(run) / "particles" / simulation_hash(run.scene);
}

fs::path SweepFolder::run(const SweepRun& run) const {
  return root_ / "runs" / run.name;
}

fs::path SweepFolder::difference(const SweepRun& a, const SweepRun& b) const {
  const std::string name = a.name + "~" + b.name;
  constexpr std::size_t longest = 240;  // file systems allow 255
  return root_ / "differences" / (name.size() <= longest ? name : text_hash(name));
}

bool SweepFolder::is_simulated(const SweepRun& run) const {
  const ParticleCache cache(particles(run), simulation_hash(run.scene));
  for (int k = run.scene.video.frame_count(); k-- > 0;)
    if (!cache.find(k))
      return false;
  return true;
}

bool SweepFolder::is_drawn(const SweepRun& run) const {
  const Json report = json_in(this->run(run) / "run.json");
  const auto has = [&](const Json& in, const char* key, const Json& value) {
    return in.is_object() && in.value(key, Json()) == value;
  };
  return has(report, "complete", true) &&
         has(report, "simulation_hash", simulation_hash(run.scene)) &&
         has(report.value("versions", Json()), "spindrift", SPINDRIFT_VERSION) &&
         has(report, "scene", to_json(run.scene)) && fs::exists(this->run(run) / "video.mp4");
}

bool SweepFolder::is_compared(const SweepPlan& plan, const SweepPair& pair) const {
  const Json found = json_in(difference(plan.runs[pair.a], plan.runs[pair.b]) / differences_file);
  return found.is_object() && found.contains("of") && found.at("of") == comparison_of(plan, pair);
}

int frame_at(const VideoConfig& video, double time) {
  return std::clamp(video.frames_per_second.count_in(time), 0, video.frame_count() - 1);
}

std::vector<SweepPair> pairs_of(const SweepPlan& plan) {
  std::vector<SweepPair> pairs;
  const bool few = plan.runs.size() <= few_runs;
  for (std::size_t a = 0; a < plan.runs.size(); ++a)
    for (std::size_t b = a + 1; b < plan.runs.size(); ++b) {
      const bool with_reference = plan.reference == a || plan.reference == b;
      if ((few || with_reference) && comparable(plan.runs[a], plan.runs[b]))
        pairs.push_back({a, b, with_reference});
    }
  return pairs;
}

Json comparison_of(const SweepPlan& plan, const SweepPair& pair) {
  const SweepRun &a = plan.runs[pair.a], &b = plan.runs[pair.b];
  const VideoConfig& shorter =
      a.scene.video.frame_count() < b.scene.video.frame_count() ? a.scene.video : b.scene.video;
  std::vector<int> pictures, frames;
  for (const double time : plan.times)
    if (time < shorter.duration)
      pictures.push_back(frame_at(shorter, time));
  std::sort(pictures.begin(), pictures.end());
  pictures.erase(std::unique(pictures.begin(), pictures.end()), pictures.end());
  frames = pictures;
  if (pair.all_frames) {
    frames.clear();
    for (int k = 0; k < shorter.frame_count(); ++k)
      frames.push_back(k);
  }
  return {{"a", video_hash(a)}, {"b", video_hash(b)}, {"frames", frames}, {"pictures", pictures}};
}

}  // namespace spindrift::app
