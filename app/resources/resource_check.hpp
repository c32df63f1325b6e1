// Checks before a run whether it fits into the machine.
#pragma once

#include "app/errors/errors.hpp"
#include "app/resources/run_options.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// Refuses a run that can't fit into memory or on the disk, unless the options force it, and warns
/// on stderr of a run that may not fit.
/// @throws InputError with the figures and what to do
void require_resources(const Scene& scene, const RenderOptions& options);

}  // namespace spindrift::app
