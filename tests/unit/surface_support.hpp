// Particle sets and mesh checks for the surface tests. Lengths are in metres.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "render/mesh.hpp"

namespace spindrift::test {

using Points = std::vector<glm::vec3>;

/// A lattice of nx x ny x nz particles that fills a box from the origin.
/// @param jitter how far each coordinate may be off, in spacings
inline Points box_of_particles(glm::ivec3 count, float spacing, float jitter = 0.0f,
                               unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> offset(-jitter, jitter);
  Points points;
  for (int z = 0; z < count.z; ++z)
    for (int y = 0; y < count.y; ++y)
      for (int x = 0; x < count.x; ++x) {
        const glm::vec3 shake(offset(random), offset(random), offset(random));
        points.push_back(spacing * (glm::vec3(x, y, z) + 0.5f + shake));
      }
  return points;
}

/// The particles of a lattice that lie in a sphere around the origin.
inline Points sphere_of_particles(float radius, float spacing) {
  const int n = 2 * int(std::ceil(radius / spacing));
  Points points;
  for (const glm::vec3& p : box_of_particles(glm::ivec3(n), spacing)) {
    const glm::vec3 centred = p - 0.5f * spacing * float(n);
    if (glm::length(centred) < radius)
      points.push_back(centred);
  }
  return points;
}

inline Points random_cloud(int count, float edge, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> anywhere(-0.5f * edge, 0.5f * edge);
  Points points(count);
  for (glm::vec3& p : points)
    p = {anywhere(random), anywhere(random), anywhere(random)};
  return points;
}

inline double volume(const Mesh& mesh) {
  double sum = 0.0;
  for (const glm::uvec3& t : mesh.triangles)
    sum += glm::dot(glm::dvec3(mesh.vertices[t.x]),
                    glm::cross(glm::dvec3(mesh.vertices[t.y]), glm::dvec3(mesh.vertices[t.z]))) /
           6.0;
  return sum;
}

inline std::string describe(const Mesh& mesh, std::uint32_t vertex) {
  const glm::vec3& p = mesh.vertices[vertex];
  return fmt::format("vertex {} at ({}, {}, {})", vertex, p.x, p.y, p.z);
}

/// What is wrong with a mesh that should be closed and manifold, and where; empty if nothing is.
inline std::string topology_fault(const Mesh& mesh) {
  if (mesh.normals.size() != mesh.vertices.size())
    return "not one normal per vertex";
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> sides;
  std::vector<std::map<std::uint32_t, std::uint32_t>> fans(mesh.vertices.size());
  for (const glm::uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      if (a >= mesh.vertices.size())
        return fmt::format("triangle corner {} of {} vertices", a, mesh.vertices.size());
      if (a == b)
        return "a triangle meets itself at " + describe(mesh, a);
      ++sides[{a, b}];
      fans[a][b] = c;
    }
  for (const auto& [side, count] : sides) {
    const auto back = sides.find({side.second, side.first});
    if (count != 1 || back == sides.end())
      return fmt::format("side from {} to {}: {} triangles one way, {} the other",
                         describe(mesh, side.first), describe(mesh, side.second), count,
                         back == sides.end() ? 0 : back->second);
  }
  // The triangles around a vertex make one ring.
  for (std::uint32_t v = 0; v < fans.size(); ++v) {
    if (fans[v].empty())
      return describe(mesh, v) + " is in no triangle";
    const std::uint32_t start = fans[v].begin()->first;
    std::size_t length = 1;
    for (std::uint32_t at = fans[v][start]; at != start && length <= fans[v].size(); ++length)
      at = fans[v][at];
    if (length != fans[v].size())
      return describe(mesh, v) + " joins several sheets";
  }
  return {};
}

/// Number of separate pieces.
inline std::size_t piece_count(const Mesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertices.size());
  for (std::uint32_t v = 0; v < parent.size(); ++v)
    parent[v] = v;
  const auto root = [&parent](std::uint32_t v) {
    while (parent[v] != v)
      v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const glm::uvec3& t : mesh.triangles) {
    parent[root(t.x)] = root(t.y);
    parent[root(t.y)] = root(t.z);
  }
  std::size_t pieces = 0;
  for (std::uint32_t v = 0; v < parent.size(); ++v)
    pieces += root(v) == v;
  return pieces;
}

}  // namespace spindrift::test
