// A solid bounded by triangles, with the search structures that collisions and sampling need.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim/geometry/mesh/distance_grid.hpp"
#include "sim/geometry/mesh/triangle_tree.hpp"
#include "sim/geometry/shapes/box.hpp"
#include "sim/geometry/surface_sample.hpp"

namespace spindrift::geometry {

/// The smallest axis-aligned box around a surface, m.
Box bounds_of(const TriangleSurface& surface);

/// A closed surface with its triangle tree and distance grid, which are built once so that contacts
/// cost little. Points are in the frame of the surface's vertices.
class MeshBody {
 public:
  /// @param surface closed: each edge is traversed as often in one direction as in the other
  /// @param spacing of the particles that the body will meet, m
  MeshBody(TriangleSurface surface, float spacing);
  MeshBody(const MeshBody&) = delete;
  MeshBody& operator=(const MeshBody&) = delete;

  const TriangleSurface& surface() const { return surface_; }
  const Box& bounds() const { return bounds_; }

  bool contains(const glm::vec3& p) const { return grid_.at(p).distance < 0; }

  /// The point on the surface nearest to `p`, if `p` is inside; otherwise `p` itself, m. The result
  /// is within a few hundredths of a spacing of the surface, and within 0.15 spacings at sharp
  /// edges, which come out rounded. Walls thinner than half a spacing are not seen.
  glm::vec3 push_out(const glm::vec3& p) const { return view_.push_out(p); }

  /// Samples half a spacing (m) below the surface, about one per spacing². Walls thinner than 1.25
  /// spacings have one denser layer, in their middle.
  std::vector<SurfaceSample> sample(float spacing) const;

  const MeshView& view() const { return view_; }
  const TriangleTree& tree() const { return tree_; }
  const DistanceGrid& grid() const { return grid_; }

 private:
  TriangleSurface surface_;
  Box bounds_;
  TriangleTree tree_;
  DistanceGrid grid_;
  MeshView view_;
};

}  // namespace spindrift::geometry
