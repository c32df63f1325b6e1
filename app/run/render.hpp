// Runs a scene, from its particles to its video, for the commands `render`, `simulate`, `sweep` and
// `golden`.
#pragma once

#include "app/errors/errors.hpp"
#include "app/files/folder_lock.hpp"
#include "app/resources/run_options.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// Simulates a scene and draws it. The run leaves its pictures, its video and run.json, the
/// particle cache, and the exports that the options ask for. One process at a time works in a
/// folder; a second one is refused. Errors of a run that has begun are printed, with a hint how to
/// continue.
/// @return the exit code
/// @throws InputError, std::runtime_error where the run could not begin
int run_render(const Scene& scene, const RenderOptions& options);

/// The same for a caller that holds the lock of the output folder, without the check that memory
/// and disk space are enough.
int run_render(const Scene& scene, const RenderOptions& options, const FolderLock& lock);

}  // namespace spindrift::app
