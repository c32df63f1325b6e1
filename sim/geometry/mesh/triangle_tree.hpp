// Triangles in a tree of boxes.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim/geometry/mesh/mesh_view.hpp"
#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::geometry {

/// Finds what is nearest to a point, and whether the point is inside.
class TriangleTree {
 public:
  /// @param surface at least one triangle
  explicit TriangleTree(const TriangleSurface& surface);

  using Nearest = NearestPoint;
  /// The surface's point nearest to p.
  /// @param guess the nearest triangle of a point close by, which makes it faster
  /// @param tolerance by which part the distance may be too large; some makes it much faster midway
  /// between many triangles, as in the centre of a ball
  Nearest nearest(const glm::vec3& p, std::uint32_t guess = 0, float tolerance = 0) const {
    return view().nearest(p, guess, tolerance);
  }

  /// How often the surface winds around p: 0 outside, 1 inside; more where closed surfaces overlap.
  /// Exact, whichever way the triangles meet, when each edge is passed as often in one direction as
  /// in the other.
  int winding_number(const glm::vec3& p) const;

  TriangleTreeView view() const { return {triangles_.data(), nodes_.data()}; }
  const std::vector<Triangle>& triangles() const { return triangles_; }
  const std::vector<TriangleNode>& nodes() const { return nodes_; }

 private:
  void build(std::uint32_t begin, std::uint32_t end);

  std::vector<Triangle> triangles_;
  std::vector<TriangleNode> nodes_;
};

}  // namespace spindrift::geometry
