// Surface of a particle liquid: a scalar field sampled near the surface only, and its iso-surface.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "render/mesh.hpp"

namespace spindrift::surface {

/// How the liquid's surface is reconstructed. Lengths are relative to the particle spacing.
struct SurfaceSettings {
  float cell_size = 0.5f;  ///< edge of a marching-cubes cell, in particle spacings; (0.1 ... 2)
  float iso_value = 0.5f;  ///< the field is 1 deep inside the liquid and 0 outside; (0.05 ... 0.95)
};

/// Closed triangle mesh around the particles (Lorensen & Cline 1987), the same for every thread
/// count.
/// @param positions particle centres, m
/// @param spacing   particle spacing, m
Mesh reconstruct_surface(std::span<const glm::vec3> positions, float spacing,
                         const SurfaceSettings& settings);

}  // namespace spindrift::surface
