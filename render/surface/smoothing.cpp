#include "render/surface/smoothing.hpp"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "render/lanes.hpp"

namespace spindrift::surface {
namespace {

// The neighbours of every vertex, in the order of the triangles: those of vertex v are
// index[begin[v]] ... index[begin[v + 1] - 1].
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

// Packs a vertex's position into lanes 0 ... 2 and its normal into lanes 3 ... 5.
Lanes to_lanes(const glm::vec3& position, const glm::vec3& normal) {
  return Lanes{position.x, position.y, position.z, normal.x, normal.y, normal.z, 0.0f, 0.0f};
}

// Takes one step of weighted Laplacian smoothing: vertex v moves by share[v] times the sum of the
// vectors to its neighbours.
void relax(const Neighbours& neighbours, const std::vector<float>& share,
           std::span<const std::uint32_t> vertices, const std::vector<Lanes>& from,
           std::vector<Lanes>& to) {
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const std::uint32_t v = vertices[i];
    const std::uint32_t begin = neighbours.begin[v];
    const std::uint32_t end = neighbours.begin[v + 1];
    const Lanes here = from[v];
    Lanes sum{};
    for (std::uint32_t k = begin; k < end; ++k)
      sum += from[neighbours.index[k]] - here;
    to[v] = here + share[v] * sum;
  }
}

// Largest share of the way to its neighbours' mean that a vertex goes in one step: if it went the
// whole way, two-coloured patterns would swing for ever.
constexpr float step = 0.7f;

// Returns the share of the way to its neighbours' mean that a vertex goes in one step: from 0 where
// the liquid is one or two layers of particles thick to `step` over the bulk.
float smoothing_weight(float bulk) {
  const float t = std::clamp((bulk - 0.6f) / (0.9f - 0.6f), 0.0f, 1.0f);
  return step * t * t * (3.0f - 2.0f * t);
}

// Applies the filter 2 L - L^2 to some of the vertices, which must make up whole pieces of the
// mesh.
class Filter {
 public:
  Filter(const Mesh& mesh, std::span<const float> bulk)
      : neighbours_(mesh), share_(bulk.size()), once_(bulk.size()), twice_(bulk.size()) {
    for (std::size_t v = 0; v < share_.size(); ++v)
      share_[v] =
          smoothing_weight(bulk[v]) / float(neighbours_.begin[v + 1] - neighbours_.begin[v]);
  }

  // Smooths the given vertices of `result`; its other vertices stay as they are.
  void smooth(std::span<const std::uint32_t> vertices, int iterations, std::vector<Lanes>& result) {
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < vertices.size(); ++i)
      once_[vertices[i]] = result[vertices[i]];
    apply(vertices, iterations, once_, result);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < vertices.size(); ++i)
      twice_[vertices[i]] = once_[vertices[i]];
    apply(vertices, iterations, twice_, result);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < vertices.size(); ++i)
      result[vertices[i]] = 2.0f * once_[vertices[i]] - twice_[vertices[i]];
  }

 private:
  // Applies L, which is `iterations` steps, to `points`; `other` is overwritten.
  void apply(std::span<const std::uint32_t> vertices, int iterations, std::vector<Lanes>& points,
             std::vector<Lanes>& other) const {
    for (int i = 0; i < iterations; ++i) {
      relax(neighbours_, share_, vertices, points, other);
      points.swap(other);
    }
  }

  Neighbours neighbours_;
  std::vector<float> share_;
  std::vector<Lanes> once_, twice_;
};

// The connected pieces of a mesh: drops, the bulk, bubbles.
class Pieces {
 public:
  explicit Pieces(const Mesh& mesh) : mesh_(mesh), of_vertex_(mesh.vertices.size()) {
    std::vector<std::uint32_t> parent(mesh.vertices.size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto root = [&](std::uint32_t v) {
      while (parent[v] != v)
        v = parent[v] = parent[parent[v]];
      return v;
    };
    for (const glm::uvec3& t : mesh.triangles) {
      const std::uint32_t a = root(t.x), b = root(t.y), c = root(t.z);
      parent[a] = parent[b] = parent[c] = std::min({a, b, c});
    }
    for (std::uint32_t v = 0; v < parent.size(); ++v) {
      const std::uint32_t r = root(v);  // the piece's first vertex
      if (r == v)
        first_.push_back(v);
      of_vertex_[v] = r == v ? std::uint32_t(first_.size() - 1) : of_vertex_[r];
    }
  }

  std::size_t count() const { return first_.size(); }

  // Returns the vertices of the chosen pieces; `chosen` has one value per piece.
  std::vector<std::uint32_t> vertices_of(const std::vector<char>& chosen) const {
    std::vector<std::uint32_t> vertices;
    for (std::uint32_t v = 0; v < of_vertex_.size(); ++v)
      if (chosen[of_vertex_[v]])
        vertices.push_back(v);
    return vertices;
  }

  std::uint32_t of_vertex(std::size_t v) const { return of_vertex_[v]; }

  // Returns the volume of every piece, below 0 for a bubble. It is summed over the triangles in
  // their order, whatever the number of threads.
  template <class Position>
  std::vector<double> volumes(const Position& position) const {
    std::vector<double> sums(count());
    for (const glm::uvec3& t : mesh_.triangles) {
      const std::uint32_t piece = of_vertex_[t.x];
      const glm::dvec3 origin(mesh_.vertices[first_[piece]]);
      const glm::dvec3 a = position(t.x) - origin, b = position(t.y) - origin,
                       c = position(t.z) - origin;
      sums[piece] += glm::dot(a, glm::cross(b, c)) / 6.0;
    }
    return sums;
  }

 private:
  const Mesh& mesh_;
  std::vector<std::uint32_t> of_vertex_;
  std::vector<std::uint32_t> first_;  // first vertex of each piece
};

glm::dvec3 position_of(const Lanes& p) {
  return {p[0], p[1], p[2]};
}

// Largest share of its volume by which smoothing may change a piece.
constexpr double most_lost = 0.01;

// Undoes smoothing, as far as needed, for the pieces whose volume it changed by more than
// most_lost. The number of iterations is halved until the change is small enough; the vertices are
// then interpolated between that result and the one before it.
// @param points vertices smoothed with `iterations`
void give_volume_back(const Mesh& mesh, Filter& filter, int iterations,
                      const std::vector<Lanes>& original, std::vector<Lanes>& points) {
  const Pieces pieces(mesh);
  const std::vector<double> whole =
      pieces.volumes([&](std::uint32_t v) { return glm::dvec3(mesh.vertices[v]); });
  const auto losses = [&](const std::vector<Lanes>& of) {
    std::vector<double> lost = pieces.volumes([&](std::uint32_t v) { return position_of(of[v]); });
    for (std::size_t piece = 0; piece < lost.size(); ++piece)
      lost[piece] = std::abs(1.0 - lost[piece] / whole[piece]);
    return lost;
  };
  std::vector<double> lost = losses(points);
  std::vector<char> beyond(pieces.count());
  for (std::size_t piece = 0; piece < beyond.size(); ++piece)
    beyond[piece] = !(lost[piece] <= most_lost);  // true for NaN: the piece has no volume
  for (std::vector<std::uint32_t> vertices = pieces.vertices_of(beyond); !vertices.empty();
       vertices = pieces.vertices_of(beyond)) {
    iterations /= 2;
    std::vector<Lanes> fewer = original;
    if (iterations > 0)
      filter.smooth(vertices, iterations, fewer);
    const std::vector<double> lost_by_fewer =
        iterations > 0 ? losses(fewer) : std::vector<double>(pieces.count());
    for (const std::uint32_t v : vertices) {
      const std::uint32_t piece = pieces.of_vertex(v);
      const double less = lost_by_fewer[piece], more = lost[piece];
      const double part = less <= most_lost && more > less ? (most_lost - less) / (more - less) : 0;
      points[v] = fewer[v] + float(part) * (points[v] - fewer[v]);
    }
    for (std::size_t piece = 0; piece < beyond.size(); ++piece)
      beyond[piece] = beyond[piece] && !(lost_by_fewer[piece] <= most_lost);
    lost = lost_by_fewer;
  }
}

}  // namespace

void smooth_mesh(Mesh& mesh, std::span<const float> bulk, int iterations) {
  if (iterations == 0)
    return;
  const std::size_t n = mesh.vertices.size();
  std::vector<Lanes> original(n);
  for (std::size_t v = 0; v < n; ++v)
    original[v] = to_lanes(mesh.vertices[v], mesh.normals[v]);
  std::vector<std::uint32_t> all(n);
  std::iota(all.begin(), all.end(), 0u);
  Filter filter(mesh, bulk);
  std::vector<Lanes> points = original;
  filter.smooth(all, iterations, points);
  give_volume_back(mesh, filter, iterations, original, points);
#pragma omp parallel for schedule(static)
  for (std::size_t v = 0; v < n; ++v) {
    const Lanes& p = points[v];
    mesh.vertices[v] = {p[0], p[1], p[2]};
    const glm::vec3 normal(p[3], p[4], p[5]);
    const float length = glm::length(normal);
    if (length > 0.1f)
      mesh.normals[v] = normal / length;
  }
}

}  // namespace spindrift::surface
