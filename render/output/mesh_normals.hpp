// A check that all writers of meshes make.
#pragma once

#include <stdexcept>
#include <string>

#include "render/mesh.hpp"

namespace spindrift::output {

/// Whether a mesh has normals. @throws std::invalid_argument where it has some, but not one for
/// each vertex
inline bool has_normals(const Mesh& mesh) {
  if (!mesh.normals.empty() && mesh.normals.size() != mesh.vertices.size())
    throw std::invalid_argument(std::to_string(mesh.normals.size()) + " normals for " +
                                std::to_string(mesh.vertices.size()) + " vertices");
  return !mesh.normals.empty();
}

}  // namespace spindrift::output
