#include "app/resources/resource_check.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/checks/estimate.hpp"
#include "app/errors/errors.hpp"
#include "app/resources/disk_estimate.hpp"
#include "app/system/machine_limits.hpp"

namespace spindrift::app {
namespace {

/// Refuses or warns of a run that needs more memory than there is.
/// @param needed memory, bytes
void require_memory(double needed, const RenderOptions& options) {
  const auto most = static_cast<double>(most_memory());
  if (needed > most && !options.force)
    throw InputError(fmt::format(
        "this needs about {} of memory, and there are {} at most; a larger fluid.spacing needs "
        "less, by its third power; --force begins all the same",
        bytes_text(needed), bytes_text(most)));
  const auto free = static_cast<double>(free_memory());
  if (needed > free && !options.quiet)
    fmt::print(stderr, "spindrift: this needs about {} of memory, and {} are free\n",
               bytes_text(needed), bytes_text(free));
}

void require_disk(const Scene& scene, const RenderOptions& options, const Estimate& cost) {
  const DiskEstimate needed = disk_estimate(scene, options, cost);
  const double there = static_cast<double>(bytes_there(scene, options));
  const auto free = static_cast<double>(free_disk(options.output));
  if (needed.sum() - there <= free)
    return;
  const std::string figures = fmt::format(
      "this takes about {} of disk space, {} of it for kept particles, and {} are free for {}",
      bytes_text(needed.sum() - there), bytes_text(needed.particles), bytes_text(free),
      options.output.string());
  // The number of particles that emitters bring and sinks take is a guess, so that only runs
  // without exchange are refused.
  const bool certain = !scene.simulation.exchanges_particles() && needed.particles - there > free;
  if (certain && !options.force)
    throw InputError(figures +
                     "; --no-cache keeps none; `spindrift cache --remove` removes those "
                     "of earlier runs; --force begins all the same");
  if (!options.quiet)
    fmt::print(stderr, "spindrift: {}\n", figures);
}

}  // namespace

void require_resources(const Scene& scene, const RenderOptions& options) {
  const Estimate cost = estimate(scene, std::max(1, options.threads));
  require_memory(cost.bytes, options);
  require_disk(scene, options, cost);
}

}  // namespace spindrift::app
