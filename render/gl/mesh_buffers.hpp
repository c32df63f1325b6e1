// Geometry on the GPU's side: triangle meshes and particle clouds.
#pragma once

#include "render/gl/gl_objects.hpp"
#include "render/gl/renderer.hpp"

namespace spindrift::gl {

/// A triangle mesh: attribute 0 is the vertex, attribute 1 its normal.
class MeshBuffers {
 public:
  MeshBuffers();
  /// @throws std::invalid_argument when normals are missing or an index is out of range.
  void set(const Mesh& mesh);
  void draw() const;

 private:
  VertexArray array_;
  Buffer vertices_, normals_, triangles_;
  GLsizei index_count_ = 0;
};

/// Particles: storage buffer 0 holds the centres, storage buffer 1 the values to colour by. Three
/// vertices each, without attributes (one draw of many is faster than many instances).
class ParticleBuffers {
 public:
  /// @throws std::invalid_argument when there is not one attribute per position.
  void set(const ParticleCloud& cloud);
  void draw() const;
  float radius() const { return radius_; }

 private:
  VertexArray no_attributes_;
  Buffer positions_, attributes_;
  GLsizei count_ = 0;
  float radius_ = 0.f;
};

}  // namespace spindrift::gl
