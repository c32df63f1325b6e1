// Makes the triangle meshes with which a scene's obstacles are drawn.
#pragma once

#include <span>
#include <vector>

#include "render/mesh.hpp"
#include "sim/core/settings.hpp"

namespace spindrift::app {

/// The triangles of all obstacles where the scene puts them, without their motion. Faces that meet
/// at an edge have vertices of their own there, so that each face keeps its normal; round sides
/// have smooth normals. Vertex normals point out of the solid.
Mesh tessellate(std::span<const sim::Obstacle> obstacles);

/// The triangles of obstacles, some of which may move.
class ObstacleMeshes {
 public:
  explicit ObstacleMeshes(std::span<const sim::Obstacle> obstacles);

  bool empty() const { return parts_.empty(); }
  /// Whether any obstacle moves.
  bool move() const { return moves_; }

  /// The triangles of all obstacles where they are at a time, s.
  Mesh at(double time) const;

  /// Two opposite corners, m, of a box that contains the moving obstacles at all of the instants,
  /// s; empty where none moves.
  std::vector<glm::vec3> reach(std::span<const double> instants) const;

 private:
  struct Part {
    sim::Obstacle obstacle;
    Mesh mesh;  ///< where the scene puts the obstacle, without its motion
  };
  std::vector<Part> parts_;
  bool moves_ = false;
};

}  // namespace spindrift::app
