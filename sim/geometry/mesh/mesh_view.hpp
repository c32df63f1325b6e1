// Views of a solid bounded by triangles for loops over particles, on the host or on a device: a
// tree for the nearest point and for intersections, and a grid of signed distances.
#pragma once

#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <utility>

#include "sim/geometry/entry.hpp"
#include "sim/geometry/host_device.hpp"

namespace spindrift::geometry {

struct Triangle {
  glm::vec3 a, b, c;  ///< m
};

/// A node of a tree of bounding boxes. A leaf holds the triangles first … first + count − 1; an
/// inner node has count 0, and its children are the next node and the node `first`.
struct TriangleNode {
  glm::vec3 low, high;  ///< corners of the bounding box, m
  std::uint32_t first, count;
};

/// The point of a surface that is nearest to another point.
struct NearestPoint {
  glm::vec3 point;         ///< on the surface, m
  float distance;          ///< from the other point, m
  std::uint32_t triangle;  ///< index in the tree of the triangle that `point` lies on
};

SPINDRIFT_HD inline float squared_distance(const glm::vec3& a, const glm::vec3& b) {
  return glm::dot(a - b, a - b);
}

/// The point nearest to p on the line segment from a to b.
SPINDRIFT_HD inline glm::vec3 nearest_on_line(const glm::vec3& p, const glm::vec3& a,
                                              const glm::vec3& b) {
  const glm::vec3 along = b - a;
  const float squared = glm::dot(along, along);
  return squared > 0 ? a + glm::clamp(glm::dot(p - a, along) / squared, 0.f, 1.f) * along : a;
}

/// The point nearest to p on a triangle: the foot of the perpendicular if it is within the
/// triangle, otherwise the nearest point of the three sides.
SPINDRIFT_HD inline glm::vec3 nearest_on_triangle(const glm::vec3& p, const Triangle& t) {
  const glm::vec3 normal = glm::cross(t.b - t.a, t.c - t.a);
  const bool within = glm::dot(glm::cross(t.b - t.a, p - t.a), normal) > 0 &&
                      glm::dot(glm::cross(t.c - t.b, p - t.b), normal) > 0 &&
                      glm::dot(glm::cross(t.a - t.c, p - t.c), normal) > 0;
  if (within)
    return p - (glm::dot(p - t.a, normal) / glm::dot(normal, normal)) * normal;
  glm::vec3 best = nearest_on_line(p, t.a, t.b);
  for (const glm::vec3& other : {nearest_on_line(p, t.b, t.c), nearest_on_line(p, t.c, t.a)})
    if (squared_distance(p, other) < squared_distance(p, best))
      best = other;
  return best;
}

SPINDRIFT_HD inline float squared_distance_to_box(const glm::vec3& p, const TriangleNode& box) {
  const glm::vec3 outside = glm::max(glm::max(box.low - p, p - box.high), 0.f);
  return glm::dot(outside, outside);
}

/// Six times the signed volume of the tetrahedron between a path and an edge from a to b, all
/// relative to the path's beginning. Exchanging a and b changes exactly the sign, so that a path
/// near the common edge of two triangles meets one of the two.
SPINDRIFT_HD inline double around_edge(const glm::dvec3& way, const glm::dvec3& a,
                                       const glm::dvec3& b) {
  return way.x * (a.y * b.z - a.z * b.y) + way.y * (a.z * b.x - a.x * b.z) +
         way.z * (a.x * b.y - a.y * b.x);
}

/// Replaces `first` by the intersection of a path with a triangle's front, if there is one and it
/// is earlier.
SPINDRIFT_HD inline void join_entry(const Triangle& t, const glm::dvec3& from,
                                    const glm::dvec3& way, Entry& first) {
  const glm::dvec3 a = glm::dvec3(t.a) - from, b = glm::dvec3(t.b) - from,
                   c = glm::dvec3(t.c) - from;
  const double ab = around_edge(way, a, b), bc = around_edge(way, b, c),
               ca = around_edge(way, c, a);
  if (ab > 0 || bc > 0 || ca > 0)
    return;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double along = glm::dot(way, normal);
  if (!(along < 0))
    return;
  const double part = glm::dot(a, normal) / along;
  if (part >= 0 && part <= 1 && (!first.found || part < double{first.part}))
    first = {true, static_cast<float>(part), glm::vec3(glm::normalize(normal))};
}

/// A view of a TriangleTree in memory that the loops can read.
struct TriangleTreeView {
  /// Size of the stack for a traversal: a tree of 2³² triangles split in halves has 32 levels.
  static constexpr int most_levels = 64;
  const Triangle* triangles = nullptr;
  const TriangleNode* nodes = nullptr;

  /// The surface's point nearest to p; TriangleTree::nearest() explains the parameters.
  SPINDRIFT_HD SPINDRIFT_APART NearestPoint nearest(const glm::vec3& p, std::uint32_t guess = 0,
                                                    float tolerance = 0) const {
    NearestPoint best{nearest_on_triangle(p, triangles[guess]), 0, guess};
    float squared = squared_distance(p, best.point);
    const float worth = (1 - tolerance) * (1 - tolerance);

    struct Waiting {
      std::uint32_t node;
      float squared;
    };
    Waiting stack[most_levels];
    int waiting = 0;
    stack[waiting++] = {0, squared_distance_to_box(p, nodes[0])};
    while (waiting > 0) {
      const Waiting next = stack[--waiting];
      if (next.squared >= worth * squared)
        continue;
      const TriangleNode& node = nodes[next.node];
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
        const glm::vec3 point = nearest_on_triangle(p, triangles[k]);
        const float candidate = squared_distance(p, point);
        if (candidate < squared) {
          squared = candidate;
          best = {point, 0, k};
        }
      }
      if (node.count > 0)
        continue;
      // The nearer child is visited first.
      Waiting nearer{node.first, squared_distance_to_box(p, nodes[node.first])};
      Waiting farther{next.node + 1, squared_distance_to_box(p, nodes[next.node + 1])};
      if (farther.squared < nearer.squared)
        std::swap(nearer, farther);
      stack[waiting++] = farther;
      stack[waiting++] = nearer;
    }
    best.distance = std::sqrt(squared);
    return best;
  }

  /// Where a straight path first passes a triangle from its front to its back.
  SPINDRIFT_HD SPINDRIFT_APART Entry entry(const glm::vec3& from, const glm::vec3& to) const {
    const glm::vec3 low = glm::min(from, to), high = glm::max(from, to);
    const glm::dvec3 begin(from), way = glm::dvec3(to) - begin;
    Entry first;
    std::uint32_t stack[most_levels];
    int waiting = 0;
    stack[waiting++] = 0;
    while (waiting > 0) {
      const std::uint32_t next = stack[--waiting];
      const TriangleNode& node = nodes[next];
      if (low.x > node.high.x || low.y > node.high.y || low.z > node.high.z ||
          high.x < node.low.x || high.y < node.low.y || high.z < node.low.z)
        continue;
      for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
        join_entry(triangles[k], begin, way, first);
      if (node.count > 0)
        continue;
      stack[waiting++] = node.first;
      stack[waiting++] = next + 1;
    }
    return first;
  }
};

/// A view of a DistanceGrid in memory that the loops can read.
struct DistanceGridView {
  /// Cells along a block's edge.
  static constexpr int block_cells = 8;
  /// Nodes along a block's edge; neighbouring blocks have a layer of nodes in common.
  static constexpr int block_nodes = block_cells + 1;
  /// Entries of `blocks` for blocks that are not stored.
  static constexpr std::int32_t outside = -1, inside = -2;

  glm::vec3 origin{0.f};                 ///< lowest corner of the grid, m
  float cell = 0;                        ///< edge of a cell, m
  glm::ivec3 counts{0};                  ///< blocks along each axis
  const std::int32_t* blocks = nullptr;  ///< index among the stored blocks, or `outside`, `inside`
  const float* values = nullptr;         ///< distances, block after block, x fastest, m

  struct Value {
    float distance;      ///< signed, m; ±∞ where nothing is stored: at least a cell away
    glm::vec3 gradient;  ///< of the distance; 0 where nothing is stored
  };

  /// The signed distance at a point (m), negative inside, by trilinear interpolation.
  SPINDRIFT_HD Value at(const glm::vec3& p) const {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const glm::vec3 u = (p - origin) * (1 / cell);
    const glm::ivec3 cells = block_cells * counts;
    const bool within = u.x >= 0 && u.y >= 0 && u.z >= 0 && u.x < static_cast<float>(cells.x) &&
                        u.y < static_cast<float>(cells.y) && u.z < static_cast<float>(cells.z);
    if (!within)
      return {infinity, glm::vec3(0)};
    const glm::ivec3 whole(u), place = whole / block_cells, local = whole - block_cells * place;
    const std::int32_t block =
        blocks[(std::size_t(place.z) * counts.y + place.y) * counts.x + place.x];
    if (block < 0)
      return {block == outside ? infinity : -infinity, glm::vec3(0)};

    constexpr std::size_t row = block_nodes, layer = row * block_nodes;
    const float* v =
        values + (std::size_t(block) * block_nodes + local.z) * layer + local.y * row + local.x;
    const glm::vec3 t = u - glm::vec3(whole);
    // Interpolates along x on the cell's four edges, then along y on two faces, then along z.
    const float near_low = mix(v[0], v[1], t.x), near_high = mix(v[row], v[row + 1], t.x);
    const float far_low = mix(v[layer], v[layer + 1], t.x),
                far_high = mix(v[layer + row], v[layer + row + 1], t.x);
    const float near = mix(near_low, near_high, t.y), far = mix(far_low, far_high, t.y);
    const float along_x =
        mix(mix(v[1] - v[0], v[row + 1] - v[row], t.y),
            mix(v[layer + 1] - v[layer], v[layer + row + 1] - v[layer + row], t.y), t.z);
    const float along_y = mix(near_high - near_low, far_high - far_low, t.z);
    return {mix(near, far, t.z), (1 / cell) * glm::vec3(along_x, along_y, far - near)};
  }

 private:
  SPINDRIFT_HD static float mix(float a, float b, float s) { return a + s * (b - a); }
};

/// A view of a MeshBody in memory that the loops can read.
struct MeshView {
  TriangleTreeView tree;
  DistanceGridView grid;
  float depth = 0;      ///< depth inside down to which the grid's distances are right, m
  float tolerance = 0;  ///< depth below the surface up to which a point counts as on it, m

  /// The point on the surface nearest to `p`, if `p` is inside; otherwise `p` itself, m.
  /// MeshBody::push_out() states the accuracy.
  SPINDRIFT_HD SPINDRIFT_APART glm::vec3 push_out(const glm::vec3& p) const {
    const DistanceGridView::Value value = grid.at(p);
    if (value.distance >= 0)
      return p;
    const float slope = glm::length(value.gradient);
    if (value.distance > -depth && slope > 0.5f) {
      const glm::vec3 out = p - (value.distance / slope) * value.gradient;
      if (grid.at(out).distance > -tolerance)
        return out;
    }
    // Midway between two sides, and far inside, the gradient does not tell the way out.
    return tree.nearest(p).point;
  }

  /// Whether a point is certainly outside and farther than `reach` (m) from the surface. The grid's
  /// interpolated distance is off by no more than half the diagonal of a cell.
  SPINDRIFT_HD bool is_clear(const glm::vec3& p, float reach) const {
    const float distance = grid.at(p).distance;
    return std::isfinite(distance) ? 0.95f * distance - 0.87f * grid.cell > reach
                                   : distance > 0 && reach < grid.cell;
  }

  /// Where a straight path enters the body, or would enter it if it went on by a margin (m); the
  /// entry's `part` is then above 1.
  SPINDRIFT_HD Entry entry(const glm::vec3& from, const glm::vec3& to, float margin) const {
    const glm::vec3 way = to - from;
    const float length = glm::length(way);
    if (!(length > 0) || is_clear(from, length + margin))
      return {};
    Entry entry = tree.entry(from, to + (margin / length) * way);
    entry.part *= (length + margin) / length;
    return entry;
  }
};

}  // namespace spindrift::geometry
