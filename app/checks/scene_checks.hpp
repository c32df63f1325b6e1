// Checks of a scene that need more than one of its values; ranges of single values are checked when
// they are read.
#pragma once

#include "app/scene/scene.hpp"
#include "app/tables/document.hpp"

namespace spindrift::app {

/// Checks that the settings of a scene fit together.
/// @param document the document that the scene was read from, for the places of its values
/// @throws SceneError with all problems, each with its place
void check_scene(const Scene& scene, const SceneDocument& document);

}  // namespace spindrift::app
