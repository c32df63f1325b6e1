// Reconstructs the surface of a particle liquid as a triangle mesh: the iso-surface of a scalar
// field that is sampled near the surface only.
#pragma once

#include <glm/glm.hpp>
#include <span>

#include "render/mesh.hpp"

namespace spindrift::surface {

/// Settings of the reconstruction; each field's comment ends with the range that is accepted.
struct SurfaceSettings {
  float cell_size = 0.55f;     ///< edge of a marching-cubes cell, in particle spacings; 0.1 ... 1
  float kernel_radius = 2.5f;  ///< support radius of a kernel, in particle spacings; 1.5 ... 4
  /// Value of the field at the surface, where it falls from 1 inside to 0 outside; 0.2 ... 0.8
  float iso_value = 0.5f;
  /// Most iterations of the filter that takes single particles' bumps off; a drop that would lose
  /// volume gets fewer; 0 ... 100
  int smoothing = 10;
};

/// Returns a closed, manifold triangle mesh around the particles, the same for every thread count.
/// The surface lies about half a spacing outside the outermost particle centres.
/// @param positions particle centres, m
/// @param spacing   particle spacing, m
/// @throws std::invalid_argument for a spacing or settings out of range, and for a particle that is
/// not finite or lies more than 2^20 cells or spacings away from the origin
Mesh reconstruct_surface(std::span<const glm::vec3> positions, float spacing,
                         const SurfaceSettings& settings);

}  // namespace spindrift::surface
