#include "render/gl/objects/mesh_buffers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace spindrift::gl {

namespace {

/// Feeds an attribute of `components` floats from a buffer that holds nothing else.
void feed(const VertexArray& array, GLuint attribute, const Buffer& buffer, int components) {
  glVertexArrayVertexBuffer(array, attribute, buffer, 0,
                            components * static_cast<GLsizei>(sizeof(float)));
  glVertexArrayAttribFormat(array, attribute, components, GL_FLOAT, GL_FALSE, 0);
  glVertexArrayAttribBinding(array, attribute, attribute);
  glEnableVertexArrayAttrib(array, attribute);
}

}  // namespace

MeshBuffers::MeshBuffers() {
  feed(array_, 0, vertices_, 3);
  feed(array_, 1, normals_, 3);
  glVertexArrayElementBuffer(array_, triangles_);
}

void MeshBuffers::set(const Mesh& mesh) {
  if (mesh.normals.size() != mesh.vertices.size()) {
    throw std::invalid_argument(fmt::format("a mesh of {} vertices has {} normals",
                                            mesh.vertices.size(), mesh.normals.size()));
  }
  glm::uvec3 highest(0);
  for (const glm::uvec3& triangle : mesh.triangles)
    highest = glm::max(highest, triangle);
  if (!mesh.triangles.empty() &&
      std::max({highest.x, highest.y, highest.z}) >= mesh.vertices.size())
    throw std::invalid_argument("a triangle of the mesh refers to a vertex that is not there");
  upload(vertices_, std::span(mesh.vertices));
  upload(normals_, std::span(mesh.normals));
  upload(triangles_, std::span(mesh.triangles));
  index_count_ = static_cast<GLsizei>(3 * mesh.triangles.size());
}

void MeshBuffers::draw() const {
  glBindVertexArray(array_);
  glDrawElements(GL_TRIANGLES, index_count_, GL_UNSIGNED_INT, nullptr);
}

void ParticleBuffers::set(const ParticleCloud& cloud) {
  if (cloud.attribute.size() != cloud.positions.size()) {
    throw std::invalid_argument(fmt::format("{} particles have {} values to colour them by",
                                            cloud.positions.size(), cloud.attribute.size()));
  }
  upload(positions_, cloud.positions);
  upload(attributes_, cloud.attribute);
  count_ = static_cast<GLsizei>(cloud.positions.size());
  radius_ = cloud.radius;
}

void ParticleBuffers::draw() const {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 0, positions_);
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 1, attributes_);
  glBindVertexArray(no_attributes_);
  glDrawArrays(GL_TRIANGLES, 0, 3 * count_);
}

}  // namespace spindrift::gl
