// A body bounded by triangles.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim/geometry/mesh/distance_grid.hpp"
#include "sim/geometry/mesh/triangle_tree.hpp"
#include "sim/geometry/shapes/box.hpp"
#include "sim/geometry/surface_sample.hpp"

namespace spindrift::geometry {

/// The smallest box around a surface.
Box bounds_of(const TriangleSurface& surface);

/// A closed surface and what is made from it once, so that contacts cost little. Points are in the
/// frame of the surface's vertices.
class MeshBody {
 public:
  /// @param surface closed: each edge is passed as often in one direction as in the other
  /// @param spacing of the particles that the body will meet, m
  MeshBody(TriangleSurface surface, float spacing);
  MeshBody(const MeshBody&) = delete;
  MeshBody& operator=(const MeshBody&) = delete;

  const TriangleSurface& surface() const { return surface_; }
  const Box& bounds() const { return bounds_; }

  bool contains(const glm::vec3& p) const { return grid_.at(p).distance < 0; }

  /// The nearest point on the surface for a point inside; a point outside comes back as it is.
  /// Within a few hundredths of a spacing of the surface, and 0.15 at sharp edges, which come out
  /// rounded. Walls thinner than half a spacing are not seen.
  glm::vec3 push_out(const glm::vec3& p) const { return view_.push_out(p); }

  /// Samples half a spacing below the surface, about one per spacing². Walls thinner than 1.25
  /// spacings have one layer, in their middle, which is closer.
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
