// Holds the geometry that is drawn, triangle meshes and particle clouds, in OpenGL's buffers.
#pragma once

#include "render/gl/look/look.hpp"
#include "render/gl/objects/gl_objects.hpp"
#include "render/mesh.hpp"

namespace spindrift::gl {

/// A triangle mesh: to the shaders attribute 0 is the vertex, attribute 1 its normal.
class MeshBuffers {
 public:
  MeshBuffers();
  /// Replaces the mesh.
  /// @throws std::invalid_argument when normals are missing or an index is out of range
  void set(const Mesh& mesh);
  /// Draws the mesh with the program in use.
  void draw() const;

 private:
  VertexArray array_;
  Buffer vertices_, normals_, triangles_;
  GLsizei index_count_ = 0;
};

/// Particles: storage buffer 0 holds the centres, storage buffer 1 the values to colour by. Each
/// particle is drawn as three vertices without attributes (one draw of many vertices is faster than
/// many instances).
class ParticleBuffers {
 public:
  /// Replaces the particles.
  /// @throws std::invalid_argument when there is not one attribute per position
  void set(const ParticleCloud& cloud);
  /// Draws the particles with the program in use.
  void draw() const;
  /// Radius of the particles, m.
  float radius() const { return radius_; }

 private:
  VertexArray no_attributes_;
  Buffer positions_, attributes_;
  GLsizei count_ = 0;
  float radius_ = 0.f;
};

}  // namespace spindrift::gl
