#include "sim/geometry/solid.hpp"

namespace spindrift::geometry {
namespace {

/// Lets solids refer to meshes where the shapes hold them, in the host's memory.
struct OwnMeshes {
  const MeshView* view_of(const MeshBody& body) const { return &body.view(); }
};

}  // namespace

Solid solid_of(const Shape& shape) {
  const OwnMeshes meshes;
  return solid_of(shape, meshes);
}

}  // namespace spindrift::geometry
