// Copies of the meshes of bodies in the device's memory, made when a run is set up.
#pragma once

#include <list>

#include "sim/backend/device/arrays.hpp"
#include "sim/geometry/mesh/mesh_body.hpp"

namespace spindrift::sim::inline device {

using namespace geometry;

class Meshes {
 public:
  /// The body's mesh on the device, copied there by the first call. It lives as long as this
  /// object.
  const MeshView* view_of(const MeshBody& body) {
    for (const Copy& copy : copies_)
      if (copy.body == &body)
        return copy.view.data();
    Copy& copy = copies_.emplace_back();
    copy.body = &body;
    put(copy.triangles, body.tree().triangles());
    put(copy.nodes, body.tree().nodes());
    put(copy.blocks, body.grid().blocks());
    put(copy.values, body.grid().values());
    MeshView view = body.view();
    view.tree = {copy.triangles.data(), copy.nodes.data()};
    view.grid.blocks = copy.blocks.data();
    view.grid.values = copy.values.data();
    put(copy.view, std::vector{view});
    return copy.view.data();
  }

  std::size_t memory_bytes() const {
    std::size_t sum = 0;
    for (const Copy& c : copies_)
      sum += bytes_of(c.triangles, c.nodes, c.blocks, c.values, c.view);
    return sum;
  }

 private:
  struct Copy {
    const MeshBody* body = nullptr;
    Array<Triangle> triangles;
    Array<TriangleNode> nodes;
    Array<std::int32_t> blocks;
    Array<float> values;
    Array<MeshView> view;  ///< one element
  };
  std::list<Copy> copies_;
};

}  // namespace spindrift::sim::inline device
