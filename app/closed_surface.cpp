#include "app/closed_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <vector>

namespace spindrift::app {
namespace {

using sim::TriangleSurface;

std::string text_of(const glm::vec3& v) {
  return fmt::format("[{:g}, {:g}, {:g}]", v.x, v.y, v.z);
}

/// The same surface with one vertex at each place, in the order of their first use, and without
/// triangles that have two corners at one place.
TriangleSurface joined(const TriangleSurface& from) {
  const auto before = [](const glm::vec3& a, const glm::vec3& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  };
  std::map<glm::vec3, std::uint32_t, decltype(before)> numbers(before);
  TriangleSurface into;
  for (const glm::uvec3& t : from.triangles) {
    glm::uvec3 corners;
    for (int k = 0; k < 3; ++k) {
      const glm::vec3 place = from.vertices[t[k]] + 0.f;  // no −0
      const auto [found, is_new] =
          numbers.emplace(place, static_cast<std::uint32_t>(into.vertices.size()));
      if (is_new) {
        into.vertices.push_back(place);
      }
      corners[k] = found->second;
    }
    if (corners.x != corners.y && corners.y != corners.z && corners.z != corners.x) {
      into.triangles.push_back(corners);
    }
  }
  return into;
}

/// A triangle's edge, the same for both directions, and which one the triangle passes it in.
struct Side {
  std::uint32_t low, high;  // vertices
  std::uint32_t triangle;
  bool upward;  // from low to high
};

/// The sides of all triangles, those of the same edge in a row.
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

/// Calls f(first, last) with the sides of each edge.
template <class F>
void for_each_edge(const std::vector<Side>& sides, F f) {
  for (std::size_t first = 0; first < sides.size();) {
    std::size_t last = first;
    while (last < sides.size() && sides[last].low == sides[first].low &&
           sides[last].high == sides[first].high) {
      ++last;
    }
    f(first, last);
    first = last;
  }
}

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
        open, open == 1 ? " is" : "s are", text_of(surface.vertices[example->low]),
        text_of(surface.vertices[example->high])));
  }
}

/// For each triangle those across its edges, and whether both pass the edge in the same direction,
/// so that one of them is turned over. Where more than two meet at an edge, none is across.
struct Neighbour {
  std::uint32_t triangle;
  bool turned;
};

std::vector<std::vector<Neighbour>> neighbours_of(std::size_t count,
                                                  const std::vector<Side>& sides) {
  std::vector<std::vector<Neighbour>> neighbours(count);
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    if (last - first == 2) {
      const Side &a = sides[first], &b = sides[first + 1];
      neighbours[a.triangle].push_back({b.triangle, a.upward == b.upward});
      neighbours[b.triangle].push_back({a.triangle, a.upward == b.upward});
    }
  });
  return neighbours;
}

/// Six times the volume between a triangle and the origin.
double six_volumes(const TriangleSurface& surface, const glm::uvec3& t) {
  const glm::dvec3 a(surface.vertices[t.x]), b(surface.vertices[t.y]), c(surface.vertices[t.z]);
  return glm::dot(a, glm::cross(b, c));
}

void turn(glm::uvec3& triangle) {
  std::swap(triangle.y, triangle.z);
}

/// Turns triangles so that neighbours pass their common edge in opposite directions. A part in
/// which any had to be turned faces outward afterwards; others keep their way, since a part that
/// faces inward is a cavity.
void turn_consistently(TriangleSurface& surface, const std::vector<Side>& sides) {
  const auto neighbours = neighbours_of(surface.triangles.size(), sides);
  enum class State : char { unseen, kept, turned };
  std::vector<State> states(surface.triangles.size(), State::unseen);
  std::vector<std::uint32_t> part;
  for (std::uint32_t start = 0; start < states.size(); ++start) {
    if (states[start] != State::unseen) {
      continue;
    }
    part.assign(1, start);
    states[start] = State::kept;
    bool any_turned = false;
    for (std::size_t k = 0; k < part.size(); ++k) {
      for (const Neighbour& next : neighbours[part[k]]) {
        const bool turned = (states[part[k]] == State::turned) != next.turned;
        const State wanted = turned ? State::turned : State::kept;
        if (states[next.triangle] == State::unseen) {
          states[next.triangle] = wanted;
          part.push_back(next.triangle);
          any_turned = any_turned || turned;
        } else if (states[next.triangle] != wanted) {
          throw MeshError("has one side only, like a Möbius strip: it has no inside");
        }
      }
    }
    if (!any_turned) {
      continue;
    }
    double volume = 0.;
    for (const std::uint32_t i : part) {
      if (states[i] == State::turned) {
        turn(surface.triangles[i]);
      }
      volume += six_volumes(surface, surface.triangles[i]);
    }
    for (const std::uint32_t i : part) {
      if (volume < 0.) {
        turn(surface.triangles[i]);
      }
    }
  }
}

/// Each edge is passed as often in one direction as in the other; with more than two triangles at
/// an edge, turning neighbours does not bring that about.
void check_directions(const TriangleSurface& surface) {
  const std::vector<Side> sides = sides_of(surface);
  for_each_edge(sides, [&](std::size_t first, std::size_t last) {
    int balance = 0;
    for (std::size_t k = first; k < last; ++k) {
      balance += sides[k].upward ? 1 : -1;
    }
    if (balance != 0) {
      throw MeshError(fmt::format(
          "has {} triangles at the edge from {} to {}, and they do not face the same way there",
          last - first, text_of(surface.vertices[sides[first].low]),
          text_of(surface.vertices[sides[first].high])));
    }
  });
}

}  // namespace

double enclosed_volume(const sim::TriangleSurface& surface) {
  double sum = 0.;
  for (const glm::uvec3& t : surface.triangles) {
    sum += six_volumes(surface, t);
  }
  return sum / 6.;
}

sim::TriangleSurface closed_surface(const sim::TriangleSurface& triangles) {
  TriangleSurface surface = joined(triangles);
  if (surface.triangles.empty()) {
    throw MeshError("has no triangles");
  }
  const std::vector<Side> sides = sides_of(surface);
  check_edges(surface, sides);
  turn_consistently(surface, sides);
  check_directions(surface);
  const double volume = enclosed_volume(surface);
  if (volume < 0.) {
    for (glm::uvec3& t : surface.triangles) {
      turn(t);
    }
  }
  glm::vec3 low = surface.vertices[0], high = low;
  for (const glm::vec3& v : surface.vertices) {
    low = glm::min(low, v);
    high = glm::max(high, v);
  }
  const double width = glm::length(glm::dvec3(high) - glm::dvec3(low));
  if (!(std::abs(volume) > 1e-9 * width * width * width)) {
    throw MeshError("encloses no volume: it is flat");
  }
  return surface;
}

}  // namespace spindrift::app
