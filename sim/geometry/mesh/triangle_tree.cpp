#include "sim/geometry/mesh/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spindrift::geometry {
namespace {

constexpr std::uint32_t most_triangles_in_leaf = 4;
/// Twice the signed area of the triangle p, a, b projected onto the plane of y and z. Exchanging a
/// and b changes exactly the sign, so that two triangles with a common edge agree on which side of
/// it p is.
double side_of(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const double ay = double{a.y} - p.y, az = double{a.z} - p.z;
  const double by = double{b.y} - p.y, bz = double{b.z} - p.z;
  return ay * bz - az * by;
}

/// +1 or −1 if, in the plane of y and z, the edge from a to b passes p on the right, upward or
/// downward in z, else 0 (Sunday 2001, "Inclusion of a point in a polygon"): the sum over a
/// polygon's edges is its winding number around p.
/// @param side side_of(p, a, b)
int crossing(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b, double side) {
  if (a.z <= p.z)
    return b.z > p.z && side > 0 ? 1 : 0;
  return b.z <= p.z && side < 0 ? -1 : 0;
}

}  // namespace

TriangleTree::TriangleTree(const TriangleSurface& surface) {
  triangles_.reserve(surface.triangles.size());
  for (const glm::uvec3& t : surface.triangles)
    triangles_.push_back({surface.vertices[t.x], surface.vertices[t.y], surface.vertices[t.z]});
  build(0, static_cast<std::uint32_t>(triangles_.size()));
}

void TriangleTree::build(std::uint32_t begin, std::uint32_t end) {
  const std::size_t index = nodes_.size();
  TriangleNode node{triangles_[begin].a, triangles_[begin].a, begin, end - begin};
  for (std::uint32_t k = begin; k < end; ++k) {
    const Triangle& t = triangles_[k];
    node.low = glm::min(node.low, glm::min(t.a, glm::min(t.b, t.c)));
    node.high = glm::max(node.high, glm::max(t.a, glm::max(t.b, t.c)));
  }
  nodes_.push_back(node);
  if (node.count <= most_triangles_in_leaf)
    return;
  const glm::vec3 size = node.high - node.low;
  const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
  const std::uint32_t middle = begin + node.count / 2;
  std::nth_element(triangles_.begin() + begin, triangles_.begin() + middle,
                   triangles_.begin() + end, [axis](const Triangle& s, const Triangle& t) {
                     return s.a[axis] + s.b[axis] + s.c[axis] < t.a[axis] + t.b[axis] + t.c[axis];
                   });
  build(begin, middle);
  nodes_[index].first = static_cast<std::uint32_t>(nodes_.size());
  nodes_[index].count = 0;
  build(middle, end);
}

int TriangleTree::winding_number(const glm::vec3& p) const {
  int winding = 0;
  // Counts triangles that the ray from p along +x crosses, with the sign of the side they face.
  const auto count = [&](const Triangle& t) {
    const double a = side_of(p, t.b, t.c), b = side_of(p, t.c, t.a), c = side_of(p, t.a, t.b);
    const int turns =
        crossing(p, t.b, t.c, a) + crossing(p, t.c, t.a, b) + crossing(p, t.a, t.b, c);
    if (turns == 0)
      return;
    const double x = (a * t.a.x + b * t.b.x + c * t.c.x) / (a + b + c);
    if (x > p.x)
      winding += turns;
  };
  std::array<std::uint32_t, TriangleTreeView::most_levels> stack;
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const std::uint32_t n = stack[--waiting];
    const TriangleNode& node = nodes_[n];
    if (p.x > node.high.x || p.y < node.low.y || p.y > node.high.y || p.z < node.low.z ||
        p.z > node.high.z)
      continue;
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
      count(triangles_[k]);
    if (node.count == 0) {
      stack[waiting++] = n + 1;
      stack[waiting++] = node.first;
    }
  }
  return winding;
}

}  // namespace spindrift::geometry
