#include "sim/geometry/mesh/polygon.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::geometry {
namespace {

/// Twice the signed area of a triangle, positive if it winds counter-clockwise.
double turn_of(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// The corners projected onto a plane of two axes, in which they wind counter-clockwise: the plane
/// nearest to the polygon's own, whose normal is that of Newell (Sutherland et al. 1974).
std::vector<glm::dvec2> flattened(const std::vector<glm::vec3>& vertices,
                                  std::span<const std::uint32_t> corners) {
  glm::dvec3 normal(0.);
  const glm::dvec3 origin(vertices[corners[0]]);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = glm::dvec3(vertices[corners[i]]) - origin;
    const glm::dvec3 b = glm::dvec3(vertices[corners[(i + 1) % corners.size()]]) - origin;
    normal += glm::cross(a, b);
  }
  int axis = 0;
  for (const int other : {1, 2})
    axis = std::abs(normal[other]) > std::abs(normal[axis]) ? other : axis;
  int u = (axis + 1) % 3, v = (axis + 2) % 3;
  if (normal[axis] < 0)
    std::swap(u, v);
  std::vector<glm::dvec2> flat;
  flat.reserve(corners.size());
  for (const std::uint32_t corner : corners)
    flat.push_back({vertices[corner][u], vertices[corner][v]});
  return flat;
}

bool is_convex(const std::vector<glm::dvec2>& flat) {
  const std::size_t n = flat.size();
  for (std::size_t i = 0; i < n; ++i)
    if (!(turn_of(flat[(i + n - 1) % n], flat[i], flat[(i + 1) % n]) > 0))
      return false;
  return true;
}

/// The ring of corners that is left of a polygon while its ears are clipped.
class Ring {
 public:
  explicit Ring(std::vector<glm::dvec2> flat) : flat_(std::move(flat)), corners_(flat_.size()) {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      corners_[i].before = (i + corners_.size() - 1) % corners_.size();
      corners_[i].after = (i + 1) % corners_.size();
    }
    for (std::size_t i = 0; i < corners_.size(); ++i)
      corners_[i].is_ear = is_ear(i);
  }

  /// Calls f(before, tip, after) for each triangle that is cut off.
  template <class F>
  void clip(F f) {
    std::size_t at = 0;
    for (std::size_t left = corners_.size(); left > 2; --left) {
      for (std::size_t looked = 0; !corners_[at].is_ear && looked < left; ++looked)
        at = corners_[at].after;
      const auto [before, after, unused] = corners_[at];
      f(before, at, after);
      corners_[before].after = after;
      corners_[after].before = before;
      corners_[before].is_ear = is_ear(before);
      corners_[after].is_ear = is_ear(after);
      at = after;
    }
  }

 private:
  struct Corner {
    std::size_t before, after;
    bool is_ear = false;
  };

  double turn_at(std::size_t i) const {
    return turn_of(flat_[corners_[i].before], flat_[i], flat_[corners_[i].after]);
  }

  /// Whether the triangle of a corner and its two neighbours lies within the polygon: no other
  /// corner is in it, except at the same positions, where a polygon touches itself around a hole.
  bool is_ear(std::size_t i) const {
    const glm::dvec2 &a = flat_[corners_[i].before], &b = flat_[i], &c = flat_[corners_[i].after];
    if (!(turn_of(a, b, c) > 0))
      return false;
    for (std::size_t k = corners_[corners_[i].after].after; k != corners_[i].before;
         k = corners_[k].after) {
      const glm::dvec2& p = flat_[k];
      const bool within = turn_of(a, b, p) >= 0 && turn_of(b, c, p) >= 0 && turn_of(c, a, p) >= 0;
      if (within && p != a && p != b && p != c && turn_at(k) <= 0)
        return false;
    }
    return true;
  }

  std::vector<glm::dvec2> flat_;
  std::vector<Corner> corners_;
};

}  // namespace

void cut_polygon(const std::vector<glm::vec3>& vertices, std::span<const std::uint32_t> corners,
                 std::vector<glm::uvec3>& into) {
  const auto cut_off = [&](std::size_t a, std::size_t b, std::size_t c) {
    into.push_back({corners[a], corners[b], corners[c]});
  };
  if (corners.size() < 3)
    return;
  if (corners.size() == 3) {
    cut_off(0, 1, 2);
    return;
  }
  std::vector<glm::dvec2> flat = flattened(vertices, corners);
  if (is_convex(flat)) {
    for (std::size_t i = 2; i < corners.size(); ++i)
      cut_off(0, i - 1, i);
    return;
  }
  if (corners.size() > most_corners) {
    throw MeshError(fmt::format(
        "a polygon has {} corners and is not convex; accepted: up to {}, so cut it into triangles",
        corners.size(), most_corners));
  }
  Ring(std::move(flat)).clip(cut_off);
}

}  // namespace spindrift::geometry
