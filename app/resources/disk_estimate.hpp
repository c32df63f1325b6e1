// Estimates the disk space that a run's files take, without running it.
#pragma once

#include <cstdint>

#include "app/checks/estimate.hpp"
#include "app/resources/run_options.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// Rough sizes of a run's files in bytes. Those of cached particles are exact where no emitter,
/// sink or open face changes the number of particles.
struct DiskEstimate {
  double particles = 0;  ///< particle cache, from which a run can be continued
  double pictures = 0;
  double video = 0;
  double exports = 0;  ///< exported particles and meshes

  double sum() const { return particles + pictures + video + exports; }
};

/// Estimates the sizes of all files that a run with these options writes.
/// @param cost the estimated cost of the scene, for its numbers of particles
DiskEstimate disk_estimate(const Scene& scene, const RenderOptions& options, const Estimate& cost);

/// The size, bytes, of files of earlier runs in the output folder that a run would keep or replace.
std::uint64_t bytes_there(const Scene& scene, const RenderOptions& options);

/// The size, bytes, of all files in a folder and below it; 0 where there is no such folder.
std::uint64_t folder_bytes(const std::filesystem::path& folder);

}  // namespace spindrift::app
