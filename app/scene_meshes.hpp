// Meshes that a scene names, read and put in their places.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/scene.hpp"
#include "app/scene_document.hpp"

namespace spindrift::app {

/// Reads the mesh files of all volumes, obstacles and sinks. @param folder that their paths start
/// from
/// @throws SceneError that names the value's place
void load_meshes(Scene& scene, const SceneDocument& document, const std::filesystem::path& folder);

/// What is worth knowing of a scene's meshes, a sentence each: those that have cavities.
std::vector<std::string> mesh_notes(const Scene& scene);

}  // namespace spindrift::app
