#include "render/surface/cube_cases.hpp"

#include <limits>
#include <utility>
#include <vector>

namespace spindrift::surface {
namespace {

using Face = std::array<int, 4>;  // corners, counter-clockwise seen from outside the cube

std::array<Face, 6> cube_faces() {
  std::array<Face, 6> faces{};
  for (int axis = 0; axis < 3; ++axis) {
    const int u = 1 << ((axis + 1) % 3);
    const int v = 1 << ((axis + 2) % 3);
    const int far_side = 1 << axis;
    faces[2 * axis] = {0, v, u | v, u};
    faces[2 * axis + 1] = {far_side, far_side | u, far_side | u | v, far_side | v};
  }
  return faces;
}

int edge_between(int corner_a, int corner_b) {
  for (int e = 0; e < 12; ++e) {
    const CubeEdge edge = cube_edge(e);
    if ((edge.corner | (1 << edge.axis)) == (corner_a | corner_b) &&
        edge.corner == (corner_a & corner_b))
      return e;
  }
  return -1;
}

bool on_one_face(int edge_a, int edge_b) {
  for (const Face& face : cube_faces()) {
    int found = 0;
    for (int i = 0; i < 4; ++i) {
      const int e = edge_between(face[i], face[(i + 1) % 4]);
      found += e == edge_a || e == edge_b;
    }
    if (found == 2)
      return true;
  }
  return false;
}

// Returns the surface's lines on the cube's faces: next[e] is the crossed edge that follows crossed
// edge e, or -1 where e is not crossed. Each run of inside corners around a face gets a line of its
// own.
std::array<int, 12> face_lines(int inside_corners) {
  const auto inside = [inside_corners](int corner) {
    return ((inside_corners >> corner) & 1) != 0;
  };
  std::array<int, 12> next;
  next.fill(-1);
  for (const Face& face : cube_faces()) {
    for (int i = 0; i < 4; ++i) {
      const int last = face[i];
      const int after = face[(i + 1) % 4];
      if (!inside(last) || inside(after))
        continue;
      int first = i;  // walk back to where this run of inside corners begins
      while (inside(face[(first + 3) % 4]))
        first = (first + 3) % 4;
      next[edge_between(face[(first + 3) % 4], face[first])] = edge_between(last, after);
    }
  }
  return next;
}

// Returns the squared distance between the middles of two edges, times 4.
int squared_length(int edge_a, int edge_b) {
  const CubeEdge a = cube_edge(edge_a);
  const CubeEdge b = cube_edge(edge_b);
  int sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const int pa = 2 * ((a.corner >> axis) & 1) + (a.axis == axis);
    const int pb = 2 * ((b.corner >> axis) & 1) + (b.axis == axis);
    sum += (pa - pb) * (pa - pb);
  }
  return sum;
}

// Length of a cut that lies in a face: larger than all the cuts of a loop without any such cut.
constexpr int forbidden = 1 << 20;

// Cuts loop[first ... last] into triangles with the shortest cuts that do not lie in a face.
// Returns the sum of the cuts' squared lengths.
int triangulate(const std::vector<int>& loop, int first, int last,
                std::vector<std::array<int, 3>>& triangles) {
  if (last - first < 2)
    return 0;
  const auto cut = [&loop](int a, int b) {
    if (b - a == 1)
      return 0;
    return on_one_face(loop[a], loop[b]) ? forbidden : squared_length(loop[a], loop[b]);
  };
  int best = std::numeric_limits<int>::max();
  std::vector<std::array<int, 3>> best_triangles;
  for (int apex = first + 1; apex < last; ++apex) {
    std::vector<std::array<int, 3>> parts{{loop[first], loop[apex], loop[last]}};
    int cost = cut(first, apex) + cut(apex, last);
    cost += triangulate(loop, first, apex, parts);
    cost += triangulate(loop, apex, last, parts);
    if (cost < best) {
      best = cost;
      best_triangles = std::move(parts);
    }
  }
  triangles.insert(triangles.end(), best_triangles.begin(), best_triangles.end());
  return best;
}

CubeCase make_case(int inside_corners) {
  std::array<int, 12> next = face_lines(inside_corners);
  CubeCase result;
  for (int start = 0; start < 12; ++start) {
    std::vector<int> loop;
    for (int e = start; next[e] >= 0;) {
      loop.push_back(e);
      e = std::exchange(next[e], -1);
    }
    std::vector<std::array<int, 3>> triangles;
    triangulate(loop, 0, int(loop.size()) - 1, triangles);
    for (const auto& t : triangles)
      result.triangles[result.triangle_count++] = {std::uint8_t(t[0]), std::uint8_t(t[1]),
                                                   std::uint8_t(t[2])};
  }
  return result;
}

}  // namespace

const std::array<CubeCase, 256>& cube_cases() {
  static const std::array<CubeCase, 256> cases = [] {
    std::array<CubeCase, 256> all;
    for (int inside_corners = 0; inside_corners < 256; ++inside_corners)
      all[inside_corners] = make_case(inside_corners);
    return all;
  }();
  return cases;
}

}  // namespace spindrift::surface
