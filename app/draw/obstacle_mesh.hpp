// Solid shapes as triangles, to be drawn.
#pragma once

#include <span>
#include <vector>

#include "render/mesh.hpp"
#include "sim/core/settings.hpp"

namespace spindrift::app {

/// Triangles of all shapes. Faces that meet at an edge have vertices of their own there, so that
/// each face keeps its normal; round sides are smooth. Normals point out of the solid.
Mesh tessellate(std::span<const sim::Obstacle> obstacles);

/// The triangles of obstacles of which some move.
class ObstacleMeshes {
 public:
  explicit ObstacleMeshes(std::span<const sim::Obstacle> obstacles);

  bool empty() const { return parts_.empty(); }
  bool move() const { return moves_; }

  /// All obstacles where they are at a time, s.
  Mesh at(double time) const;

  /// Two corners of a box around all that moves at any of the times, s; none where nothing moves.
  std::vector<glm::vec3> reach(std::span<const double> times) const;

 private:
  struct Part {
    sim::Obstacle obstacle;
    Mesh mesh;  ///< where the scene puts it
  };
  std::vector<Part> parts_;
  bool moves_;
};

}  // namespace spindrift::app
