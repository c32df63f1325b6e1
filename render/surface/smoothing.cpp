#include "render/surface/smoothing.hpp"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

namespace spindrift::surface {
namespace {

// Every vertex's neighbours, in increasing order.
struct Neighbours {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> index;

  // In a closed mesh every side of every triangle is met once in each direction, so that a vertex's
  // neighbours are the corners that follow it in its triangles.
  explicit Neighbours(const Mesh& mesh)
      : begin(mesh.vertices.size() + 1), index(3 * mesh.triangles.size()) {
    for (const glm::uvec3& t : mesh.triangles)
      for (int k = 0; k < 3; ++k)
        ++begin[t[k] + 1];
    for (std::size_t v = 1; v < begin.size(); ++v)
      begin[v] += begin[v - 1];

    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
      const glm::uvec3& t = mesh.triangles[i];
      for (int k = 0; k < 3; ++k)
        index[std::atomic_ref(next[t[k]]).fetch_add(1, std::memory_order_relaxed)] = t[(k + 1) % 3];
    }
#pragma omp parallel for schedule(static)
    for (std::size_t v = 0; v < next.size(); ++v)
      std::sort(index.begin() + begin[v], index.begin() + begin[v + 1]);
  }
};

struct Point {
  glm::vec3 position, normal;
};

// One step of weighted Laplacian smoothing.
void relax(const Neighbours& neighbours, const std::vector<float>& weight,
           const std::vector<Point>& from, std::vector<Point>& to) {
#pragma omp parallel for schedule(static)
  for (std::size_t v = 0; v < from.size(); ++v) {
    Point sum{glm::vec3(0.0f), glm::vec3(0.0f)};
    for (std::uint32_t k = neighbours.begin[v]; k < neighbours.begin[v + 1]; ++k) {
      const Point& p = from[neighbours.index[k]];
      sum.position += p.position - from[v].position;
      sum.normal += p.normal - from[v].normal;
    }
    const float share = weight[v] / float(neighbours.begin[v + 1] - neighbours.begin[v]);
    to[v] = {from[v].position + share * sum.position, from[v].normal + share * sum.normal};
  }
}

void relax(const Neighbours& neighbours, const std::vector<float>& weight, int iterations,
           std::vector<Point>& points) {
  std::vector<Point> other(points.size());
  for (int i = 0; i < iterations; ++i) {
    relax(neighbours, weight, points, other);
    points.swap(other);
  }
}

// Largest share of the way to the neighbours' mean: a full step would let two-coloured patterns
// swing for ever.
constexpr float kStep = 0.7f;

// From none where the liquid is one or two layers of particles thick to full over the bulk.
float smoothing_weight(float bulk) {
  const float t = std::clamp((bulk - 0.6f) / (0.9f - 0.6f), 0.0f, 1.0f);
  return kStep * t * t * (3.0f - 2.0f * t);
}

}  // namespace

void smooth_mesh(Mesh& mesh, std::span<const float> bulk, int iterations) {
  if (iterations == 0)
    return;
  const std::size_t n = mesh.vertices.size();
  const Neighbours neighbours(mesh);
  std::vector<float> weight(n);
  std::vector<Point> once(n);
  for (std::size_t v = 0; v < n; ++v) {
    weight[v] = smoothing_weight(bulk[v]);
    once[v] = {mesh.vertices[v], mesh.normals[v]};
  }
  relax(neighbours, weight, iterations, once);
  std::vector<Point> twice = once;
  relax(neighbours, weight, iterations, twice);
#pragma omp parallel for schedule(static)
  for (std::size_t v = 0; v < n; ++v) {
    mesh.vertices[v] = 2.0f * once[v].position - twice[v].position;
    const glm::vec3 normal = 2.0f * once[v].normal - twice[v].normal;
    const float length = glm::length(normal);
    if (length > 0.1f)
      mesh.normals[v] = normal / length;
  }
}

}  // namespace spindrift::surface
