#include <fmt/core.h>

#include "app/checks/estimate.hpp"
#include "app/checks/scene_warnings.hpp"
#include "app/commands/commands.hpp"
#include "app/errors/errors.hpp"
#include "app/resources/disk_estimate.hpp"
#include "app/system/machine_limits.hpp"
#include "app/tables/frame_rate_text.hpp"
#include "app/tables/values.hpp"

namespace spindrift::app {
namespace {

/// A duration as text, with no more digits than an estimate deserves.
std::string rough_duration_text(double seconds) {
  if (seconds < 100.)
    return fmt::format("{:.0f} s", seconds + 0.5);
  return seconds < 6000. ? fmt::format("{:.0f} min", seconds / 60.)
                         : fmt::format("{:.1f} h", seconds / 3600.);
}

}  // namespace

int run_check(const Scene& scene, int threads, bool quiet, bool json) {
  if (quiet)
    return done;
  const Estimate cost = estimate(scene, threads);
  const DiskEstimate disk = disk_estimate(scene, {}, cost);
  const nlohmann::ordered_json resolved = to_json(scene);
  const std::vector<Diagnostic> warnings = warnings_of(scene);
  if (json) {
    nlohmann::ordered_json told = nlohmann::ordered_json::array();
    for (const Diagnostic& warning : warnings)
      told.push_back({{"path", warning.path}, {"message", warning.message}});
    const nlohmann::ordered_json report{
        {"scene", resolved},
        {"simulation_hash", simulation_hash(scene)},
        {"particles", cost.particles},
        {"boundary_particles_about", cost.boundary_particles},
        {"frames", scene.video.frame_count()},
        {"memory_bytes_about", cost.bytes},
        {"disk_bytes_about",
         {{"particles", disk.particles}, {"pictures", disk.pictures}, {"video", disk.video}}},
        {"seconds_about", cost.seconds},
        {"threads", threads},
        {"warnings", told}};
    fmt::print("{}\n", report.dump(2));
    return done;
  }
  fmt::print("{}\n", to_text(resolved));
  const char* most = scene.simulation.exchanges_particles() ? "at most " : "";
  fmt::print("particles   {}{} of liquid, about {} on walls and obstacles\n", most, cost.particles,
             cost.boundary_particles);
  fmt::print("pictures    {} of {}x{} pixels, {:g} s at {} per second\n", scene.video.frame_count(),
             scene.video.width, scene.video.height, scene.video.duration,
             rate_text(scene.video.frames_per_second));
  fmt::print("memory      about {:.0f} MB\n", cost.bytes / 1e6);
  fmt::print("disk        about {}: {} for kept particles, {} for pictures, {} for the video\n",
             bytes_text(disk.sum()), bytes_text(disk.particles), bytes_text(disk.pictures),
             bytes_text(disk.video));
  fmt::print("time        roughly {} with {} thread{}\n", rough_duration_text(cost.seconds),
             threads, threads == 1 ? "" : "s");
  for (const Diagnostic& warning : warnings)
    fmt::print("warning     {}: {}\n", warning.path, warning.message);
  return done;
}

}  // namespace spindrift::app
