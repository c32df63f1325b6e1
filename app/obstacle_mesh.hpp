// Solid shapes as triangles, to be drawn.
#pragma once

#include <span>

#include "render/mesh.hpp"
#include "sim/settings.hpp"

namespace spindrift::app {

/// Triangles of all shapes. Faces that meet at an edge have vertices of their own there, so that
/// each face keeps its normal; round sides are smooth. Normals point out of the solid.
Mesh tessellate(std::span<const sim::Obstacle> obstacles);

}  // namespace spindrift::app
