// Triangle meshes of shapes, for the renderer.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

namespace spindrift::geometry {

/// Triangles with vertex normals, counter-clockwise seen from outside. Faces that meet at a sharp
/// edge have separate vertices there, so that each keeps its normal.
struct Tessellation {
  std::vector<glm::vec3> vertices;    ///< m
  std::vector<glm::vec3> normals;     ///< one per vertex: outward unit normals
  std::vector<glm::uvec3> triangles;  ///< indices of three vertices each

  /// Appends a vertex. @return its index
  unsigned add_vertex(const glm::vec3& position, const glm::vec3& normal) {
    vertices.push_back(position);
    normals.push_back(normal);
    return static_cast<unsigned>(vertices.size() - 1);
  }
  void add_triangle(unsigned a, unsigned b, unsigned c) { triangles.push_back({a, b, c}); }
  /// Appends two triangles for four corners that run counter-clockwise seen from outside.
  void add_quad(unsigned a, unsigned b, unsigned c, unsigned d) {
    add_triangle(a, b, c);
    add_triangle(a, c, d);
  }
};

/// Number of straight pieces that a circle is drawn with.
inline constexpr unsigned pieces_of_circle = 64;

/// The angle at which one of the pieces of a circle begins, radians.
inline float angle_of_piece(unsigned piece) {
  return 2.f * std::numbers::pi_v<float> * static_cast<float>(piece) /
         static_cast<float>(pieces_of_circle);
}

}  // namespace spindrift::geometry
