#include "sim/geometry/mesh/shells.hpp"

#include <algorithm>
#include <optional>

#include "sim/geometry/box_tree.hpp"
#include "sim/geometry/mesh/triangle_tree.hpp"

namespace spindrift::geometry {
namespace {

/// The most points that are looked up, and the most pairs of shells with touching bounding boxes
/// that are compared, which takes some seconds.
constexpr std::size_t most_lookups = 10'000'000, most_pairs = 200'000'000;

/// Points nearer to a shell than this fraction of its width count as neither inside nor outside.
constexpr float surface_part = 1e-5f;

/// A shell, prepared for tests of which others it contains.
class Enclosure {
 public:
  Enclosure(const TriangleSurface& surface, const Shell& shell)
      : triangles_(shell.triangles), volume_(shell.volume) {
    low_ = high_ = surface.vertices[surface.triangles[triangles_.front()].x];
    for (const std::uint32_t i : triangles_) {
      for (int k = 0; k < 3; ++k) {
        const glm::vec3& corner = surface.vertices[surface.triangles[i][k]];
        low_ = glm::min(low_, corner);
        high_ = glm::max(high_, corner);
      }
    }
  }

  const glm::vec3& low() const { return low_; }
  const glm::vec3& high() const { return high_; }
  double volume() const { return volume_; }

  /// Whether another shell lies wholly within this one.
  /// @param lookups increases by the number of points that are looked up
  bool contains(const Enclosure& other, const TriangleSurface& surface, std::size_t& lookups) {
    if (glm::any(glm::lessThan(other.low_, low_)) ||
        glm::any(glm::greaterThan(other.high_, high_)) || volume_ <= other.volume_)
      return false;
    bool any_inside = false;
    for (const std::uint32_t i : other.triangles_) {
      const glm::uvec3& t = surface.triangles[i];
      const glm::vec3 &a = surface.vertices[t.x], &b = surface.vertices[t.y],
                      &c = surface.vertices[t.z];
      for (const glm::vec3& place : {a, b, c, (a + b + c) / 3.f}) {
        ++lookups;
        const bool inside = tree(surface).winding_number(place) > 0;
        if (inside && any_inside)
          continue;
        const bool decided = tree(surface).nearest(place).distance > surface_part * width();
        if (decided && !inside)
          return false;
        any_inside = any_inside || decided;
      }
    }
    return any_inside;
  }

 private:
  float width() const { return glm::length(high_ - low_); }

  /// The tree of the shell's triangles, built on first use.
  const TriangleTree& tree(const TriangleSurface& surface) {
    if (!tree_) {
      TriangleSurface part;
      for (const std::uint32_t i : triangles_) {
        part.triangles.push_back(glm::uvec3(0, 1, 2) +
                                 static_cast<std::uint32_t>(part.vertices.size()));
        for (int k = 0; k < 3; ++k)
          part.vertices.push_back(surface.vertices[surface.triangles[i][k]]);
      }
      tree_.emplace(part);
    }
    return *tree_;
  }

  const std::vector<std::uint32_t>& triangles_;
  double volume_;
  glm::vec3 low_, high_;
  std::optional<TriangleTree> tree_;
};

}  // namespace

std::vector<std::size_t> cavities_among(const TriangleSurface& surface,
                                        const std::vector<Shell>& shells) {
  std::vector<Enclosure> enclosures;
  std::vector<Box> boxes;
  for (const Shell& shell : shells) {
    const Enclosure& enclosure = enclosures.emplace_back(surface, shell);
    boxes.push_back({enclosure.low(), enclosure.high()});
  }
  const BoxTree tree(boxes);
  std::vector<std::size_t> cavities;
  std::vector<std::uint32_t> near;
  std::size_t lookups = 0, pairs = 0;
  for (std::size_t i = 0; i < enclosures.size(); ++i) {
    tree.find(boxes[i], near);
    pairs += near.size();
    const auto around = std::count_if(near.begin(), near.end(), [&](std::uint32_t j) {
      return enclosures[j].contains(enclosures[i], surface, lookups);
    });
    if (around % 2 != 0)
      cavities.push_back(i);
    if (lookups > most_lookups || pairs > most_pairs)
      throw MeshError("has too many parts within each other to tell what is hollow");
  }
  return cavities;
}

}  // namespace spindrift::geometry
