// Takes the bumps of single particles off a surface, and leaves its shape, its volume and its thin
// features.
//
// Laplacian smoothing moves every vertex towards the mean of its neighbours; where the liquid is
// thin it is held back, after Loeschner, Boettcher, Rhys Jeske & Bender 2023, "Weighted Laplacian
// smoothing for surface reconstruction of particle-based fluids". What it takes from the shape at
// large is given back by twicing (Tukey 1977, "Exploratory data analysis"): with L the smoothing,
// 2 L - L^2 = 1 - (1 - L)^2 shrinks as the square of what L alone does. That is not enough for many
// iterations over coarse cells or small drops: a connected piece that would lose more than 1 % of
// its volume is smoothed with fewer iterations.
#pragma once

#include <span>

#include "render/mesh.hpp"

namespace spindrift::surface {

/// Smooths the vertices and vertex normals of a mesh.
/// @param mesh       closed mesh
/// @param bulk       per vertex: 1 over thick liquid, smaller where it is thin
/// @param iterations most steps of Laplacian smoothing that make up L; 0 leaves the mesh as it is
void smooth_mesh(Mesh& mesh, std::span<const float> bulk, int iterations);

}  // namespace spindrift::surface
