// A bounding volume hierarchy of the triangles of a surface.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim/geometry/mesh/mesh_view.hpp"
#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::geometry {

/// Finds the point of a surface nearest to a given point, and whether that point is inside.
class TriangleTree {
 public:
  /// @param surface at least one triangle
  explicit TriangleTree(const TriangleSurface& surface);

  using Nearest = NearestPoint;
  /// The surface's point nearest to p, m.
  /// @param guess the nearest triangle of a point close by, which speeds up the search
  /// @param tolerance the fraction by which the distance may be too large; some tolerance makes the
  /// search much faster midway between many triangles, as in the centre of a ball
  Nearest nearest(const glm::vec3& p, std::uint32_t guess = 0, float tolerance = 0) const {
    return view().nearest(p, guess, tolerance);
  }

  /// The winding number of the surface around p: 0 outside, 1 inside, more where closed surfaces
  /// overlap. It is exact, however the triangles meet, if each edge is traversed as often in one
  /// direction as in the other.
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
