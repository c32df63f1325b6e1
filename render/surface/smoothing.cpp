#include "render/surface/smoothing.hpp"

#include <omp.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "render/surface/lanes.hpp"

namespace spindrift::surface {
namespace {

// Every vertex's neighbours, in the order of the triangles.
struct Neighbours {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint32_t> index;

  // In a closed mesh every side of every triangle is met once in each direction, so that a vertex's
  // neighbours are the corners that follow it in its triangles. Each thread looks for those of its
  // own share of the vertices.
  explicit Neighbours(const Mesh& mesh)
      : begin(mesh.vertices.size() + 1), index(3 * mesh.triangles.size()) {
    for (const glm::uvec3& t : mesh.triangles)
      for (int k = 0; k < 3; ++k)
        ++begin[t[k] + 1];
    for (std::size_t v = 1; v < begin.size(); ++v)
      begin[v] += begin[v - 1];

    std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
#pragma omp parallel
    {
      const std::size_t thread = std::size_t(omp_get_thread_num());
      const std::size_t threads = std::size_t(omp_get_num_threads());
      const std::size_t first = next.size() * thread / threads;
      const std::size_t end = next.size() * (thread + 1) / threads;
      for (const glm::uvec3& t : mesh.triangles)
        for (int k = 0; k < 3; ++k)
          if (t[k] >= first && t[k] < end)
            index[next[t[k]]++] = t[(k + 1) % 3];
    }
  }
};

// A vertex's position in lanes 0 ... 2, its normal in lanes 3 ... 5.
Lanes to_lanes(const glm::vec3& position, const glm::vec3& normal) {
  return Lanes{position.x, position.y, position.z, normal.x, normal.y, normal.z, 0.0f, 0.0f};
}

// One step of weighted Laplacian smoothing: every vertex takes this share of each of the ways to
// its neighbours.
void relax(const Neighbours& neighbours, const std::vector<float>& share,
           const std::vector<Lanes>& from, std::vector<Lanes>& to) {
#pragma omp parallel for schedule(static)
  for (std::size_t v = 0; v < from.size(); ++v) {
    const std::uint32_t begin = neighbours.begin[v];
    const std::uint32_t end = neighbours.begin[v + 1];
    const Lanes here = from[v];
    Lanes sum{};
    for (std::uint32_t k = begin; k < end; ++k)
      sum += from[neighbours.index[k]] - here;
    to[v] = here + share[v] * sum;
  }
}

void relax(const Neighbours& neighbours, const std::vector<float>& share, int iterations,
           std::vector<Lanes>& points) {
  std::vector<Lanes> other(points.size());
  for (int i = 0; i < iterations; ++i) {
    relax(neighbours, share, points, other);
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
  std::vector<float> share(n);
  std::vector<Lanes> once(n);
  for (std::size_t v = 0; v < n; ++v) {
    share[v] = smoothing_weight(bulk[v]) / float(neighbours.begin[v + 1] - neighbours.begin[v]);
    once[v] = to_lanes(mesh.vertices[v], mesh.normals[v]);
  }
  relax(neighbours, share, iterations, once);
  std::vector<Lanes> twice = once;
  relax(neighbours, share, iterations, twice);
#pragma omp parallel for schedule(static)
  for (std::size_t v = 0; v < n; ++v) {
    const Lanes p = 2.0f * once[v] - twice[v];
    mesh.vertices[v] = {p[0], p[1], p[2]};
    const glm::vec3 normal(p[3], p[4], p[5]);
    const float length = glm::length(normal);
    if (length > 0.1f)
      mesh.normals[v] = normal / length;
  }
}

}  // namespace spindrift::surface
