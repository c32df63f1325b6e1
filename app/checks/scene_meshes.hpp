// Meshes that a scene names, read and put in their places.
#pragma once

#include <filesystem>
#include <vector>

#include "app/checks/exchange_checks.hpp"
#include "app/scene/scene.hpp"
#include "app/tables/document.hpp"

namespace spindrift::app {

/// Reads the mesh files of all volumes, obstacles and sinks. @param folder that their paths start
/// from
/// @throws SceneError that names the value's place
void load_meshes(Scene& scene, const SceneDocument& document, const std::filesystem::path& folder);

/// The scene's meshes that have cavities, with the path of each.
std::vector<Complaint> mesh_warnings(const Scene& scene);

}  // namespace spindrift::app
