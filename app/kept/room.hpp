// Whether a run fits into the machine.
#pragma once

#include "app/errors/errors.hpp"
#include "app/kept/run_options.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// Refuses a run that can't fit into memory or on the disk, unless the options override that, and
/// warns of one that may not. @throws InputError with the figures and what to do
void require_room(const Scene& scene, const RenderOptions& options);

}  // namespace spindrift::app
