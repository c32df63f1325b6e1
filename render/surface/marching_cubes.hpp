// The iso-surface of a sparse field as a closed mesh (Lorensen & Cline 1987).
#pragma once

#include <vector>

#include "render/mesh.hpp"
#include "render/surface/sparse_field.hpp"

namespace spindrift::surface {

struct IsoSurface {
  Mesh mesh;                ///< lengths in metres; normals from the field's gradient
  std::vector<float> bulk;  ///< per vertex: the field two spacings below, 1 over thick liquid
};

/// @param spacing m
IsoSurface march_cubes(const SparseField& field, float iso_value, float spacing);

}  // namespace spindrift::surface
