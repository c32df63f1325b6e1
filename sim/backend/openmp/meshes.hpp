// Access to the meshes of bodies for loops on the CPU, which use them without a copy.
#pragma once

#include <cstddef>

#include "sim/geometry/mesh/mesh_body.hpp"

namespace spindrift::sim::inline openmp {

class Meshes {
 public:
  const geometry::MeshView* view_of(const geometry::MeshBody& body) { return &body.view(); }
  std::size_t memory_bytes() const { return 0; }
};

}  // namespace spindrift::sim::inline openmp
