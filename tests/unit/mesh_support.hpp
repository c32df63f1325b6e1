// Closed surfaces for the tests of meshes. Lengths are in metres.
#pragma once

#include <cmath>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "sim/geometry/mesh/mesh_body.hpp"

namespace spindrift::test {

inline geometry::TriangleSurface box_mesh(const glm::vec3& min, const glm::vec3& max) {
  geometry::TriangleSurface mesh;
  for (int k = 0; k < 8; ++k)
    mesh.vertices.push_back({k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z});
  const unsigned faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
  for (const auto& f : faces) {
    mesh.triangles.push_back({f[0], f[1], f[2]});
    mesh.triangles.push_back({f[0], f[2], f[3]});
  }
  return mesh;
}

/// A box whose triangles are split in four, `times` times, and blown up to a ball.
inline geometry::TriangleSurface ball_mesh(const glm::vec3& center, float radius, int times) {
  geometry::TriangleSurface mesh = box_mesh(glm::vec3(-1), glm::vec3(1));
  for (int k = 0; k < times; ++k) {
    std::map<std::pair<unsigned, unsigned>, unsigned> middles;
    const auto middle = [&](unsigned a, unsigned b) {
      const auto [found, is_new] =
          middles.emplace(std::minmax(a, b), static_cast<unsigned>(mesh.vertices.size()));
      if (is_new)
        mesh.vertices.push_back(0.5f * (mesh.vertices[a] + mesh.vertices[b]));
      return found->second;
    };
    std::vector<glm::uvec3> smaller;
    for (const glm::uvec3& t : mesh.triangles) {
      const unsigned a = middle(t.x, t.y), b = middle(t.y, t.z), c = middle(t.z, t.x);
      for (const glm::uvec3& part : {glm::uvec3(t.x, a, c), glm::uvec3(t.y, b, a),
                                     glm::uvec3(t.z, c, b), glm::uvec3(a, b, c)})
        smaller.push_back(part);
    }
    mesh.triangles = smaller;
  }
  for (glm::vec3& v : mesh.vertices)
    v = center + radius * glm::normalize(v);
  return mesh;
}

/// A closed profile of (distance from the axis, height), from the axis to the axis,
/// counter-clockwise with the axis on the left, turned about the y axis through `base`.
inline geometry::TriangleSurface turned_mesh(const std::vector<glm::vec2>& profile, unsigned around,
                                             const glm::vec3& base) {
  geometry::TriangleSurface mesh;
  std::vector<std::vector<unsigned>> rings;
  for (const glm::vec2& p : profile) {
    rings.emplace_back();
    for (unsigned i = 0; i < around; ++i) {
      if (p.x > 0 || i == 0) {
        const double angle = 2 * std::numbers::pi * i / around;
        mesh.vertices.push_back(base +
                                glm::vec3(p.x * std::cos(angle), p.y, -p.x * std::sin(angle)));
      }
      rings.back().push_back(static_cast<unsigned>(mesh.vertices.size() - 1));
    }
  }
  for (std::size_t k = 0; k + 1 < rings.size(); ++k)
    for (unsigned i = 0; i < around; ++i) {
      const unsigned j = (i + 1) % around;
      if (rings[k][i] != rings[k][j])
        mesh.triangles.push_back({rings[k][i], rings[k][j], rings[k + 1][j]});
      if (rings[k + 1][i] != rings[k + 1][j])
        mesh.triangles.push_back({rings[k][i], rings[k + 1][j], rings[k + 1][i]});
    }
  return mesh;
}

/// A round cup that stands on `base`, open at the top.
inline geometry::TriangleSurface cup_mesh(const glm::vec3& base, float inner_radius, float height,
                                          float wall) {
  const float outer = inner_radius + wall;
  return turned_mesh({{0, 0},
                      {outer, 0},
                      {outer, height},
                      {inner_radius, height},
                      {inner_radius, wall},
                      {0, wall}},
                     32, base);
}

/// An L of arms one metre long and 0.4 m thick, one metre deep.
inline geometry::TriangleSurface l_mesh() {
  const glm::vec2 outline[] = {{0, 0}, {1, 0}, {1, 0.4}, {0.4, 0.4}, {0.4, 1}, {0, 1}};
  geometry::TriangleSurface mesh;
  for (const float z : {0.f, 1.f})
    for (const glm::vec2& p : outline)
      mesh.vertices.push_back({p, z});
  for (unsigned k = 1; k + 1 < 6; ++k) {
    mesh.triangles.push_back({0, k + 1, k});
    mesh.triangles.push_back({6, k + 6, k + 7});
  }
  for (unsigned k = 0; k < 6; ++k) {
    const unsigned next = (k + 1) % 6;
    mesh.triangles.push_back({k, next, next + 6});
    mesh.triangles.push_back({k, next + 6, k + 6});
  }
  return mesh;
}

/// A ring in the plane of x and z around the origin.
inline geometry::TriangleSurface torus_mesh(float radius, float thickness, unsigned around = 64) {
  geometry::TriangleSurface mesh;
  const unsigned across = around / 2;
  for (unsigned j = 0; j < across; ++j)
    for (unsigned i = 0; i < around; ++i) {
      const double u = 2 * std::numbers::pi * i / around, v = 2 * std::numbers::pi * j / across;
      const double r = radius + thickness * std::cos(v);
      mesh.vertices.push_back({r * std::cos(u), thickness * std::sin(v), -r * std::sin(u)});
    }
  const auto at = [&](unsigned i, unsigned j) { return (j % across) * around + i % around; };
  for (unsigned j = 0; j < across; ++j)
    for (unsigned i = 0; i < around; ++i) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// Turned to no axis of the grid, and moved off its nodes.
inline geometry::TriangleSurface askew(geometry::TriangleSurface mesh) {
  const glm::mat3 turn({0.36f, 0.48f, -0.8f}, {-0.8f, 0.6f, 0.f}, {0.48f, 0.64f, 0.6f});
  for (glm::vec3& v : mesh.vertices)
    v = turn * v + glm::vec3(0.013f, 0.017f, 0.011f);
  return mesh;
}

/// Both surfaces as one; the second one's triangles turned over on request, which makes a cavity.
inline geometry::TriangleSurface joined(geometry::TriangleSurface a,
                                        const geometry::TriangleSurface& b,
                                        bool turn_over = false) {
  const auto first = static_cast<unsigned>(a.vertices.size());
  a.vertices.insert(a.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const glm::uvec3& t : b.triangles)
    a.triangles.push_back(first + (turn_over ? glm::uvec3(t.x, t.z, t.y) : t));
  return a;
}

inline geometry::TriangleMesh solid(geometry::TriangleSurface surface, float spacing) {
  geometry::TriangleMesh mesh;
  mesh.body = std::make_shared<const geometry::MeshBody>(std::move(surface), spacing);
  return mesh;
}

/// `count` places spread evenly over a surface.
inline std::vector<glm::vec3> places_on(const geometry::TriangleSurface& surface, int count) {
  std::vector<double> areas;
  double area = 0;
  for (const glm::uvec3& t : surface.triangles) {
    const glm::vec3 a = surface.vertices[t.x];
    area += 0.5 * glm::length(glm::cross(surface.vertices[t.y] - a, surface.vertices[t.z] - a));
    areas.push_back(area);
  }
  std::vector<glm::vec3> places;
  std::size_t at = 0;
  for (int k = 0; k < count; ++k) {
    const double wanted = area * (k + 0.5) / count;
    while (areas[at] < wanted)
      ++at;
    // Two numbers that fill the triangle evenly (Roberts 2018, the R2 sequence), folded over.
    float u = static_cast<float>(std::fmod(0.7548776662466927 * k, 1.));
    float v = static_cast<float>(std::fmod(0.5698402909980532 * k, 1.));
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const glm::uvec3& t = surface.triangles[at];
    const glm::vec3 a = surface.vertices[t.x];
    places.push_back(a + u * (surface.vertices[t.y] - a) + v * (surface.vertices[t.z] - a));
  }
  return places;
}

}  // namespace spindrift::test
