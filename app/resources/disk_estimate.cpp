#include "app/resources/disk_estimate.hpp"

#include <cmath>

#include "app/files/folder_entries.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

constexpr double bytes_per_cached_particle = 40;  // position, velocity and four further numbers
constexpr double bytes_per_cached_boundary_particle = 4;
// Measured on pictures of the shipped scenes: 0.3 at 1280x720 pixels, 0.3 to 0.75 at 480x270.
constexpr double png_bytes_per_pixel = 0.5;
constexpr double video_bytes_per_pixel = 0.013;  // at quality 18; adding 6 to the quality halves it

}  // namespace

DiskEstimate disk_estimate(const Scene& scene, const RenderOptions& options, const Estimate& cost) {
  const VideoConfig& video = scene.video;
  const double all = video.frame_count();
  const double drawn = options.frames ? options.frames->last - options.frames->first + 1 : all;
  const double simulated = options.frames ? options.frames->last + 1 : all;
  const auto particles = static_cast<double>(cost.particles);
  const double pixels = drawn * video.width * video.height;
  DiskEstimate result;
  if (options.cache && !options.from_particles)
    result.particles = simulated * (particles * bytes_per_cached_particle +
                                    static_cast<double>(cost.boundary_particles) *
                                        bytes_per_cached_boundary_particle);
  if (!options.simulate_only) {
    result.pictures = pixels * png_bytes_per_pixel;
    result.video = pixels * video_bytes_per_pixel * std::exp2((18 - video.quality) / 6.);
  }
  for (const ExportFormat* format : options.exports)
    result.exports += drawn * format->bytes(particles);
  return result;
}

std::uint64_t folder_bytes(const fs::path& folder) {
  std::uint64_t sum = 0;
  for (const fs::directory_entry& entry : entries_below(folder)) {
    std::error_code gone;
    const bool regular = entry.is_regular_file(gone);
    const std::uintmax_t size = regular ? entry.file_size(gone) : 0;
    sum += gone ? 0 : size;
  }
  return sum;
}

std::uint64_t bytes_there(const Scene& scene, const RenderOptions& options) {
  const fs::path& folder = options.output;
  std::uint64_t sum = folder_bytes(folder / "frames");
  for (const ExportFormat& format : export_formats())
    sum += folder_bytes(folder / format.folder);
  return options.cache ? sum + folder_bytes(folder / "particles" / simulation_hash(scene)) : sum;
}

}  // namespace spindrift::app
