#include "sim/shapes/triangle_tree.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace spindrift::sim {
namespace {

constexpr std::uint32_t most_in_leaf = 4;
constexpr std::size_t most_levels = 64;  // a tree of 2³² triangles split in halves has 32

/// The point nearest to p on the line from a to b.
glm::vec3 nearest_on_line(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 along = b - a;
  const float squared = glm::dot(along, along);
  return squared > 0 ? a + glm::clamp(glm::dot(p - a, along) / squared, 0.f, 1.f) * along : a;
}

float squared_distance(const glm::vec3& a, const glm::vec3& b) {
  return glm::dot(a - b, a - b);
}

/// The point nearest to p on a triangle: the foot of the perpendicular where that is within, else
/// the nearest point of the three sides.
glm::vec3 nearest_on_triangle(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b,
                              const glm::vec3& c) {
  const glm::vec3 normal = glm::cross(b - a, c - a);
  const bool within = glm::dot(glm::cross(b - a, p - a), normal) > 0 &&
                      glm::dot(glm::cross(c - b, p - b), normal) > 0 &&
                      glm::dot(glm::cross(a - c, p - c), normal) > 0;
  if (within)
    return p - (glm::dot(p - a, normal) / glm::dot(normal, normal)) * normal;
  const glm::vec3 sides[] = {nearest_on_line(p, a, b), nearest_on_line(p, b, c),
                             nearest_on_line(p, c, a)};
  return *std::min_element(std::begin(sides), std::end(sides), [&](const auto& x, const auto& y) {
    return squared_distance(p, x) < squared_distance(p, y);
  });
}

float squared_distance_to_box(const glm::vec3& p, const glm::vec3& low, const glm::vec3& high) {
  const glm::vec3 outside = glm::max(glm::max(low - p, p - high), 0.f);
  return glm::dot(outside, outside);
}

/// Twice the area of the triangle p, a, b in the plane of y and z. It changes its sign exactly, and
/// nothing else, when a and b change places, so that two triangles with a common edge agree on
/// which side of it p is.
double side_of(const glm::vec3& p, const glm::vec3& a, const glm::vec3& b) {
  const double ay = double{a.y} - p.y, az = double{a.z} - p.z;
  const double by = double{b.y} - p.y, bz = double{b.z} - p.z;
  return ay * bz - az * by;
}

/// +1 or −1 where, in the plane of y and z, the edge from a to b passes p on the right, upward or
/// downward in z (Sunday 2001, "Inclusion of a point in a polygon"): the sum over a polygon's edges
/// is how often it winds around p.
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
  Node node{triangles_[begin].a, triangles_[begin].a, begin, end - begin};
  for (std::uint32_t k = begin; k < end; ++k) {
    const Triangle& t = triangles_[k];
    node.low = glm::min(node.low, glm::min(t.a, glm::min(t.b, t.c)));
    node.high = glm::max(node.high, glm::max(t.a, glm::max(t.b, t.c)));
  }
  nodes_.push_back(node);
  if (node.count <= most_in_leaf)
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

TriangleTree::Nearest TriangleTree::nearest(const glm::vec3& p, std::uint32_t guess,
                                            float tolerance) const {
  const auto point_of = [&](std::uint32_t k) {
    return nearest_on_triangle(p, triangles_[k].a, triangles_[k].b, triangles_[k].c);
  };
  Nearest best{point_of(guess), 0, guess};
  float squared = squared_distance(p, best.point);
  const float worth = (1 - tolerance) * (1 - tolerance);

  struct Waiting {
    std::uint32_t node;
    float squared;
  };
  std::array<Waiting, most_levels> stack;
  std::size_t waiting = 0;
  const auto wait = [&](std::uint32_t n) {
    stack[waiting++] = {n, squared_distance_to_box(p, nodes_[n].low, nodes_[n].high)};
  };
  wait(0);
  while (waiting > 0) {
    const Waiting next = stack[--waiting];
    if (next.squared >= worth * squared)
      continue;
    const Node& node = nodes_[next.node];
    for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
      const glm::vec3 point = point_of(k);
      const float candidate = squared_distance(p, point);
      if (candidate < squared) {
        squared = candidate;
        best = {point, 0, k};
      }
    }
    if (node.count == 0) {  // the nearer child is looked at first
      wait(next.node + 1);
      wait(node.first);
      if (stack[waiting - 2].squared < stack[waiting - 1].squared)
        std::swap(stack[waiting - 2], stack[waiting - 1]);
    }
  }
  best.distance = std::sqrt(squared);
  return best;
}

int TriangleTree::winding_number(const glm::vec3& p) const {
  int winding = 0;
  // Triangles that the ray from p along +x passes, counted by the way that they face.
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
  std::array<std::uint32_t, most_levels> stack;
  std::size_t waiting = 0;
  stack[waiting++] = 0;
  while (waiting > 0) {
    const std::uint32_t n = stack[--waiting];
    const Node& node = nodes_[n];
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

}  // namespace spindrift::sim
