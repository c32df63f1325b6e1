#include "sim/geometry/mesh/smooth_normals.hpp"

namespace spindrift::geometry {
namespace {

/// Cosine of the largest angle between two faces that are drawn as one round surface.
constexpr float smooth_cosine = 0.8f;

struct Face {
  glm::vec3 normal{0.f};  ///< of unit length
  glm::vec3 angles{0.f};  ///< at its corners, radians
};

Face face_of(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c) {
  Face face;
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const float length = glm::length(normal);
  if (length > 0.f) {
    face.normal = normal / length;
    const auto angle_at = [length](const glm::vec3& u, const glm::vec3& v) {
      return std::atan2(length, glm::dot(u, v));
    };
    face.angles = {angle_at(b - a, c - a), angle_at(c - b, a - b), angle_at(a - c, b - c)};
  }
  return face;
}

/// One corner of a triangle.
struct Corner {
  std::size_t triangle;
  int number;  ///< 0, 1 or 2
};

/// The vertex normal at a corner, given all corners around the same vertex and all faces.
glm::vec3 normal_at(const Corner& corner, const std::vector<Corner>& around,
                    const std::vector<Face>& faces) {
  glm::vec3 sum{0.f};
  for (const Corner& other : around) {
    const Face& face = faces[other.triangle];
    if (glm::dot(face.normal, faces[corner.triangle].normal) > smooth_cosine)
      sum += face.angles[other.number] * face.normal;
  }
  return sum == glm::vec3{0.f} ? glm::vec3{0.f, 1.f, 0.f} : glm::normalize(sum);
}

}  // namespace

void tessellate_smooth(Tessellation& into, const TriangleSurface& surface) {
  std::vector<std::vector<Corner>> corners(surface.vertices.size());
  std::vector<Face> faces;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    const glm::uvec3& t = surface.triangles[i];
    faces.push_back(face_of(surface.vertices[t.x], surface.vertices[t.y], surface.vertices[t.z]));
    for (int k = 0; k < 3; ++k)
      corners[t[k]].push_back({i, k});
  }
  const std::size_t first_triangle = into.triangles.size();
  into.triangles.resize(first_triangle + surface.triangles.size());
  for (std::size_t v = 0; v < corners.size(); ++v) {
    const std::size_t first_vertex = into.vertices.size();
    for (const Corner& corner : corners[v]) {
      const glm::vec3 normal = normal_at(corner, corners[v], faces);
      std::size_t vertex = first_vertex;
      while (vertex < into.vertices.size() && into.normals[vertex] != normal)
        ++vertex;
      if (vertex == into.vertices.size())
        into.add_vertex(surface.vertices[v], normal);
      into.triangles[first_triangle + corner.triangle][corner.number] =
          static_cast<unsigned>(vertex);
    }
  }
}

}  // namespace spindrift::geometry
