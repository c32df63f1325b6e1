// Extracts the iso-surface of a sparse field as a closed mesh by marching cubes (Lorensen & Cline
// 1987).
#pragma once

#include <vector>

#include "render/mesh.hpp"
#include "render/surface/sparse_field.hpp"

namespace spindrift::surface {

/// An iso-surface, and how thick the liquid is below it.
struct IsoSurface {
  Mesh mesh;                ///< closed; vertex normals follow the field's gradient
  std::vector<float> bulk;  ///< per vertex: the field two spacings below, 1 over thick liquid
};

/// Returns the surface on which the field has the iso-value.
/// @param spacing particle spacing, m
IsoSurface march_cubes(const SparseField& field, float iso_value, float spacing);

}  // namespace spindrift::surface
