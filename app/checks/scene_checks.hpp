// What can only be seen with the whole scene in hand.
#pragma once

#include "app/scene/scene.hpp"
#include "app/tables/document.hpp"

namespace spindrift::app {

/// Checks that the settings fit together. @throws SceneError with all that do not, each with its
/// place
void check_scene(const Scene& scene, const SceneDocument& document);

}  // namespace spindrift::app
