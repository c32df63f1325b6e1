// Shapes as triangles, to be drawn.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <vector>

namespace spindrift::geometry {

/// Triangles with normals at their vertices, counter-clockwise seen from outside. Faces that meet
/// at an edge have vertices of their own there, so that each keeps its normal.
struct Tessellation {
  std::vector<glm::vec3> vertices;    ///< m
  std::vector<glm::vec3> normals;     ///< of unit length, out of the solid
  std::vector<glm::uvec3> triangles;  ///< numbers of three vertices each

  unsigned add_vertex(const glm::vec3& position, const glm::vec3& normal) {
    vertices.push_back(position);
    normals.push_back(normal);
    return static_cast<unsigned>(vertices.size() - 1);
  }
  void add_triangle(unsigned a, unsigned b, unsigned c) { triangles.push_back({a, b, c}); }
  /// Two triangles; the corners run counter-clockwise seen from outside.
  void add_quad(unsigned a, unsigned b, unsigned c, unsigned d) {
    add_triangle(a, b, c);
    add_triangle(a, c, d);
  }
};

inline constexpr unsigned pieces_of_circle = 64;

/// Where a piece of a full circle begins, radians.
inline float angle_of_piece(unsigned piece) {
  return 2.f * std::numbers::pi_v<float> * static_cast<float>(piece) /
         static_cast<float>(pieces_of_circle);
}

}  // namespace spindrift::geometry
