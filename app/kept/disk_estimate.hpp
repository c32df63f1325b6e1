// How much room on the disk a run's files take, without running it.
#pragma once

#include <cstdint>

#include "app/checks/estimate.hpp"
#include "app/kept/run_options.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// Bytes, roughly; those of kept particles are exact where nothing comes or goes.
struct DiskEstimate {
  double particles = 0;  ///< kept, to go on with
  double pictures = 0;
  double video = 0;
  double exports = 0;

  double sum() const { return particles + pictures + video + exports; }
};

/// @param cost of the scene
DiskEstimate disk_estimate(const Scene& scene, const RenderOptions& options, const Estimate& cost);

/// Bytes of files that a run has left in its folder, and would keep or replace.
std::uint64_t bytes_there(const Scene& scene, const RenderOptions& options);

/// Bytes of all files in a folder and below; 0: there is none.
std::uint64_t folder_bytes(const std::filesystem::path& folder);

}  // namespace spindrift::app
