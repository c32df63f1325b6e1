// Loads the mesh files that a scene names and places the meshes in the scene.
#pragma once

#include <filesystem>
#include <vector>

#include "app/checks/diagnostic.hpp"
#include "app/scene/scene.hpp"
#include "app/tables/document.hpp"

namespace spindrift::app {

/// Reads the mesh files of all volumes, obstacles and sinks, and sets the bodies of these meshes.
/// @param folder the folder to which the files' paths are relative
/// @throws SceneError with the place of every mesh that can't be used
void load_meshes(Scene& scene, const SceneDocument& document, const std::filesystem::path& folder);

/// A warning for every mesh of the scene that has cavities.
std::vector<Diagnostic> mesh_warnings(const Scene& scene);

}  // namespace spindrift::app
