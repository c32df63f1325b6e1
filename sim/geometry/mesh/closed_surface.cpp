#include "sim/geometry/mesh/closed_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <span>
#include <tuple>
#include <utility>
#include <vector>

#include "sim/geometry/mesh/shells.hpp"
#include "sim/geometry/vector_text.hpp"

namespace spindrift::geometry {
namespace {

/// Whether a point comes before another in lexicographic order of x, y and z.
template <class Place>
bool is_before(const Place& a, const Place& b) {
  return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

/// The same surface with one vertex at each position, in the order of their first use, and without
/// triangles that have two corners at the same position.
TriangleSurface joined(const TriangleSurface& from) {
  std::map<glm::vec3, std::uint32_t, decltype(&is_before<glm::vec3>)> numbers(is_before);
  TriangleSurface into;
  for (const glm::uvec3& t : from.triangles) {
    glm::uvec3 corners;
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 place = from.vertices[t[k]] + 0.f;  // turns −0 into 0
      const auto [found, is_new] =
          numbers.emplace(place, static_cast<std::uint32_t>(into.vertices.size()));
      if (is_new)
        into.vertices.push_back(place);
      corners[k] = found->second;
    }
    if (corners.x != corners.y && corners.y != corners.z && corners.z != corners.x)
      into.triangles.push_back(corners);
  }
  return into;
}

/// One edge of one triangle. The edge itself has no direction; `upward` is the direction in which
/// the triangle traverses it.
struct Side {
  std::uint32_t low, high;  ///< indices of the edge's two vertices
  std::uint32_t triangle;
  bool upward;  ///< whether the triangle goes from low to high
};

/// The sides of all triangles, sorted so that those of the same edge follow each other.
std::vector<Side> sides_of(const TriangleSurface& surface) {
  std::vector<Side> sides;
  sides.reserve(3 * surface.triangles.size());
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const std::uint32_t a = surface.triangles[i][k], b = surface.triangles[i][(k + 1) % 3];
      sides.push_back({std::min(a, b), std::max(a, b), i, a < b});
    }
  }
  std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return sides;
}

/// Calls f(first, last) for each edge with the range of its sides, last excluded.
template <class F>
void for_each_edge(const std::vector<Side>& sides, F f) {
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first;
    while (last < sides.size() && sides[last].low == sides[first].low &&
           sides[last].high == sides[first].high)
      ++last;
    f(first, last);
    first = last;
  }
}

/// @throws MeshError if an edge has an odd number of triangles
void check_edges(const TriangleSurface& surface, const std::vector<Side>& sides) {
  std::size_t open = 0;
  const Side* example = nullptr;
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    if ((last - first) % 2 != 0) {
      ++open;
      example = example ? example : &sides[first];
    }
  });
  if (open > 0) {
    throw MeshError(fmt::format(
        "is not closed: {} edge{} without a neighbour, the first from {} to {}; a solid needs an "
        "inside, so close the holes and put vertices that belong together at the same place",
        open, open == 1 ? " is" : "s are", vector_text(surface.vertices[example->low]),
        vector_text(surface.vertices[example->high])));
  }
}

/// Whether each edge has an even number of triangles.
bool is_closed(const TriangleSurface& surface) {
  bool closed = true;
  for_each_edge(sides_of(surface), [&](std::size_t first, std::size_t last) {
    closed = closed && (last - first) % 2 == 0;
  });
  return closed;
}

/// The surface without doubled triangles. Triangles with the same corners count once if the surface
/// is closed like that, as in a mesh that is stored twice or drawn with two sides; otherwise pairs
/// of them cancel, as between two boxes that touch.
TriangleSurface without_doubles(const TriangleSurface& surface) {
  const auto key = [&](std::uint32_t i) {
    glm::uvec3 t = surface.triangles[i];
    std::sort(&t.x, &t.x + 3);
    return std::tuple(t.x, t.y, t.z);
  };
  std::vector<std::uint32_t> order(surface.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](auto i, auto j) { return key(i) < key(j); });
  std::vector<char> once(order.size(), 0), odd(order.size(), 0);
  for (std::size_t first = 0, last = 0; first < order.size(); first = last) {
    while (last < order.size() && key(order[last]) == key(order[first]))
      ++last;
    once[order[first]] = 1;
    odd[order[first]] = (last - first) % 2 != 0;
  }
  if (once == odd && std::count(once.begin(), once.end(), 0) == 0)
    return surface;
  const auto chosen = [&](const std::vector<char>& wanted) {
    TriangleSurface some{surface.vertices, {}};
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (wanted[i])
        some.triangles.push_back(surface.triangles[i]);
    return some;
  };
  TriangleSurface single = chosen(once);
  return is_closed(single) ? single : chosen(odd);
}

/// The triangle across an edge of another. It is `turned` where both traverse the edge in the same
/// direction, so that one of them must be flipped.
struct Neighbour {
  std::uint32_t triangle;
  bool turned;
};
using Neighbours = std::vector<std::array<Neighbour, 3>>;

/// Sorts the sides of an edge by the angle at which their triangles lie around it. The order
/// depends on positions alone, not on how vertices are numbered or triangles wound.
void sort_around_edge(const TriangleSurface& surface, std::span<Side> sides) {
  const auto place = [&](std::uint32_t vertex) { return glm::dvec3(surface.vertices[vertex]); };
  glm::dvec3 from = place(sides[0].low), to = place(sides[0].high);
  if (is_before(to, from))
    std::swap(from, to);
  const glm::dvec3 axis = glm::normalize(to - from);
  struct Around {
    glm::dvec3 corner, way;  ///< the triangle's third corner, and from the edge to it, m
    double angle;
    Side side;
  };
  std::vector<Around> all;
  for (const Side& side : sides) {
    const glm::uvec3& t = surface.triangles[side.triangle];
    const glm::dvec3 corner = place(t.x ^ t.y ^ t.z ^ side.low ^ side.high);
    const glm::dvec3 way = corner - from;
    all.push_back({corner, way - glm::dot(way, axis) * axis, 0, side});
  }
  // Angles count from the longest `way`, which is sure to have a direction.
  const glm::dvec3 start =
      std::max_element(all.begin(), all.end(), [](const Around& a, const Around& b) {
        const double of_a = glm::length(a.way), of_b = glm::length(b.way);
        return of_a < of_b || (of_a == of_b && is_before(a.corner, b.corner));
      })->way;
  const glm::dvec3 across = glm::cross(axis, start);
  for (Around& one : all)
    one.angle = std::atan2(glm::dot(across, one.way), glm::dot(start, one.way));
  std::stable_sort(all.begin(), all.end(), [](const Around& a, const Around& b) {
    return a.angle < b.angle || (a.angle == b.angle && is_before(a.corner, b.corner));
  });
  std::transform(all.begin(), all.end(), sides.begin(), [](const Around& one) { return one.side; });
}

/// The neighbours across each triangle's three edges. Where more than two triangles meet at an
/// edge, they are paired in their order around it, so that no sheet passes through another.
Neighbours neighbours_of(const TriangleSurface& surface, std::vector<Side>& sides) {
  Neighbours neighbours(surface.triangles.size());
  std::vector<unsigned char> known(surface.triangles.size(), 0);
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first > 2)
      sort_around_edge(surface, std::span(sides).subspan(first, last - first));
    for (std::size_t k = first; k + 1 < last; k += 2) {
      const Side &a = sides[k], &b = sides[k + 1];
      neighbours[a.triangle][known[a.triangle]++] = {b.triangle, a.upward == b.upward};
      neighbours[b.triangle][known[b.triangle]++] = {a.triangle, a.upward == b.upward};
    }
  });
  return neighbours;
}

/// The signed volume between some triangles of a surface and one of their corners, m³: the volume
/// that they enclose, if they are closed.
double volume_of(const TriangleSurface& surface, const std::vector<std::uint32_t>& part) {
  const glm::dvec3 origin(surface.vertices[surface.triangles[part.front()].x]);
  double sum = 0.;
  for (const std::uint32_t i : part) {
    const glm::uvec3& t = surface.triangles[i];
    const glm::dvec3 a(surface.vertices[t.x]), b(surface.vertices[t.y]), c(surface.vertices[t.z]);
    sum += glm::dot(a - origin, glm::cross(b - origin, c - origin));
  }
  return sum / 6.;
}

/// Flips a triangle: reverses its winding.
void turn(glm::uvec3& triangle) {
  std::swap(triangle.y, triangle.z);
}

/// Flips triangles so that neighbours traverse their common edge in opposite directions.
/// @return the surface's connected parts, each as the indices of its triangles
/// @throws MeshError if that is impossible
std::vector<std::vector<std::uint32_t>> turned_parts(TriangleSurface& surface,
                                                     const Neighbours& neighbours) {
  enum class State : char { unseen, kept, turned };
  std::vector<State> states(surface.triangles.size(), State::unseen);
  std::vector<std::vector<std::uint32_t>> parts;
  for (std::uint32_t start = 0; start < states.size(); ++start) {
    if (states[start] != State::unseen)
      continue;
    std::vector<std::uint32_t>& part = parts.emplace_back(1, start);
    states[start] = State::kept;
    for (std::size_t k = 0; k < part.size(); ++k) {
      for (const Neighbour& next : neighbours[part[k]]) {
        const bool turned = (states[part[k]] == State::turned) != next.turned;
        const State wanted = turned ? State::turned : State::kept;
        if (states[next.triangle] == State::unseen) {
          states[next.triangle] = wanted;
          part.push_back(next.triangle);
        } else if (states[next.triangle] != wanted) {
          throw MeshError("has one side only, like a Möbius strip: it has no inside");
        }
      }
    }
  }
  for (std::size_t i = 0; i < states.size(); ++i)
    if (states[i] == State::turned)
      turn(surface.triangles[i]);
  return parts;
}

void turn_all(TriangleSurface& surface, const std::vector<std::uint32_t>& part) {
  for (const std::uint32_t i : part)
    turn(surface.triangles[i]);
}

/// @throws MeshError if the surface encloses next to no volume for its size
void check_volume(const TriangleSurface& surface) {
  glm::vec3 low = surface.vertices[0], high = low;
  for (const glm::vec3& v : surface.vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  const double width = glm::length(glm::dvec3(high) - glm::dvec3(low));
  if (!(enclosed_volume(surface) > 1e-9 * width * width * width))
    throw MeshError("encloses no volume: it is flat");
}

}  // namespace

std::size_t inner_shells(const TriangleSurface& closed) {
  TriangleSurface surface = closed;
  std::vector<Side> sides = sides_of(surface);
  const auto parts = turned_parts(surface, neighbours_of(surface, sides));
  return static_cast<std::size_t>(std::count_if(
      parts.begin(), parts.end(), [&](const auto& part) { return volume_of(surface, part) < 0.; }));
}

TriangleSurface closed_surface(const TriangleSurface& triangles) {
  TriangleSurface surface = joined(triangles);
  if (surface.triangles.empty())
    throw MeshError("has no triangles");
  surface = without_doubles(surface);
  std::vector<Side> sides = sides_of(surface);
  check_edges(surface, sides);
  const auto parts = turned_parts(surface, neighbours_of(surface, sides));
  std::vector<Shell> shells;
  for (const auto& part : parts) {
    const double volume = volume_of(surface, part);
    if (volume < 0.)
      turn_all(surface, part);
    shells.push_back({part, std::abs(volume)});
  }
  for (const std::size_t cavity : cavities_among(surface, shells))
    turn_all(surface, parts[cavity]);
  check_volume(surface);
  return surface;
}

}  // namespace spindrift::geometry
