// Surface of a particle liquid: a scalar field sampled near the surface only, and its iso-surface.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "render/mesh.hpp"

namespace spindrift::surface {

/// How the liquid's surface is reconstructed. Lengths are relative to the particle spacing.
struct SurfaceSettings {
  float cell_size = 0.55f;     ///< edge of a marching-cubes cell, in particle spacings; 0.1 ... 1
  float kernel_radius = 2.5f;  ///< reach of a particle's kernel, in particle spacings; 1.5 ... 4
  float iso_value = 0.5f;      ///< the field is 1 deep in the liquid and 0 outside; 0.2 ... 0.8
  int smoothing = 10;  ///< iterations that take single particles' bumps off, as far as every
                       ///< drop keeps its volume; 0 ... 100
};

/// Closed, manifold triangle mesh around the particles, the same for every thread count.
/// The surface lies about half a spacing outside the outermost particle centres.
/// @param positions particle centres, m
/// @param spacing   particle spacing, m
/// @throws std::invalid_argument for settings out of range, and for a particle that is not finite
/// or
///        more than 2^20 cells or spacings away from the origin
Mesh reconstruct_surface(std::span<const glm::vec3> positions, float spacing,
                         const SurfaceSettings& settings);

}  // namespace spindrift::surface
