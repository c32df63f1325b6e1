// Runs from a scene to its video.
#pragma once

#include "app/errors/errors.hpp"
#include "app/files/folder_lock.hpp"
#include "app/kept/run_options.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// Simulates a scene, and draws it; leaves its pictures, its video and run.json, the particles and
/// what else the options ask for. One process at a time works in a folder: a second one is refused.
/// @throws InputError, std::runtime_error where nothing has been begun
int run_render(const Scene& scene, const RenderOptions& options);

/// The same, by a caller that holds the folder's lock.
int run_render(const Scene& scene, const RenderOptions& options, const FolderLock& lock);

}  // namespace spindrift::app
