// What the renderer's tests share: small meshes, pixels, and where a point falls in the picture.
#pragma once

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "render/gl/renderer.hpp"

namespace spindrift::gl::test {

using Pixel = glm::ivec3;

inline Pixel pixel(const Image& image, int x, int y) {
  const auto i = static_cast<std::size_t>(3 * (y * image.width + x));
  return {image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]};
}

inline int difference(Pixel a, Pixel b) {
  const glm::ivec3 d = glm::abs(a - b);
  return std::max({d.x, d.y, d.z});
}

inline int sum(Pixel p) {
  return p.x + p.y + p.z;
}

/// Position in the picture, pixels from its top left corner.
inline glm::vec2 project(glm::vec3 p, const View& view, glm::vec2 size) {
  const glm::mat4 m =
      glm::perspective(glm::radians(view.vertical_fov), size.x / size.y, 0.01f, 100.f) *
      glm::lookAt(view.position, view.target, view.up);
  const glm::vec4 clip = m * glm::vec4(p, 1.f);
  return glm::vec2(0.5f + 0.5f * clip.x / clip.w, 0.5f - 0.5f * clip.y / clip.w) * size;
}

inline void add_quad(Mesh& mesh, const std::array<glm::vec3, 4>& corners) {
  const auto first = static_cast<unsigned>(mesh.vertices.size());
  const glm::vec3 normal =
      glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0]));
  for (const glm::vec3& corner : corners) {
    mesh.vertices.push_back(corner);
    mesh.normals.push_back(normal);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

/// A closed box, counter-clockwise seen from outside.
inline Mesh box(glm::vec3 a, glm::vec3 b) {
  Mesh mesh;
  add_quad(mesh, {{{a.x, a.y, b.z}, {b.x, a.y, b.z}, {b.x, b.y, b.z}, {a.x, b.y, b.z}}});
  add_quad(mesh, {{{b.x, a.y, a.z}, {a.x, a.y, a.z}, {a.x, b.y, a.z}, {b.x, b.y, a.z}}});
  add_quad(mesh, {{{b.x, a.y, b.z}, {b.x, a.y, a.z}, {b.x, b.y, a.z}, {b.x, b.y, b.z}}});
  add_quad(mesh, {{{a.x, a.y, a.z}, {a.x, a.y, b.z}, {a.x, b.y, b.z}, {a.x, b.y, a.z}}});
  add_quad(mesh, {{{a.x, b.y, b.z}, {b.x, b.y, b.z}, {b.x, b.y, a.z}, {a.x, b.y, a.z}}});
  add_quad(mesh, {{{a.x, a.y, a.z}, {b.x, a.y, a.z}, {b.x, a.y, b.z}, {a.x, a.y, b.z}}});
  return mesh;
}

/// A closed ball of 2 x 32 x 32 triangles less those at its poles.
inline Mesh ball(glm::vec3 centre, float radius) {
  constexpr unsigned n = 32;
  constexpr float pi = 3.14159265f;
  Mesh mesh;
  for (unsigned i = 0; i <= n; ++i) {
    for (unsigned j = 0; j < n; ++j) {
      const float polar = pi * static_cast<float>(i) / n;
      const float around = 2.f * pi * static_cast<float>(j) / n;
      const glm::vec3 normal(std::sin(polar) * std::sin(around), std::cos(polar),
                             std::sin(polar) * std::cos(around));
      mesh.vertices.push_back(centre + radius * normal);
      mesh.normals.push_back(normal);
    }
  }
  for (unsigned i = 0; i < n; ++i) {
    for (unsigned j = 0; j < n; ++j) {
      const unsigned a = i * n + j, b = i * n + (j + 1) % n;
      if (i > 0)
        mesh.triangles.push_back({a, b + n, b});
      if (i + 1 < n)
        mesh.triangles.push_back({a, a + n, b + n});
    }
  }
  return mesh;
}

inline void append(Mesh& mesh, const Mesh& more) {
  const auto first = static_cast<unsigned>(mesh.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), more.vertices.begin(), more.vertices.end());
  mesh.normals.insert(mesh.normals.end(), more.normals.begin(), more.normals.end());
  for (const glm::uvec3& triangle : more.triangles)
    mesh.triangles.push_back(triangle + first);
}

}  // namespace spindrift::gl::test
