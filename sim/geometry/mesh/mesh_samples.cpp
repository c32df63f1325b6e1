#include "sim/geometry/mesh/mesh_samples.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>
#include <unordered_map>
#include <unordered_set>

namespace spindrift::geometry {
namespace {

/// Walls up to `one_layer` spacings thick have one layer of samples, in their middle: two would be
/// too near to each other. In walls up to `two_layers` spacings thick each of the two layers knows
/// which side it is on.
constexpr float one_layer = 1.25f, two_layers = 2.5f;

/// The least distance between samples, in spacings, which gives about one sample per spacing²; the
/// single layer of a thin wall is denser.
constexpr float least_distance = 0.9f, least_distance_single = 0.7f;

/// A point on the surface and the outward normal there.
struct Place {
  glm::vec3 point;   ///< m
  glm::vec3 normal;  ///< of unit length
};

/// The sample that a place on the surface asks for.
struct Candidate {
  SurfaceSample sample;
  glm::vec3 normal;  ///< outward, of unit length
  int sides = 1;     ///< faces that meet there, roughly: 1 on a face, 2 at an edge, 3 at a corner
};

/// Calls f(point) for points all over a triangle, on rows along its longest side, at most `step`
/// (m) apart.
template <class F>
void cover_triangle(glm::vec3 a, glm::vec3 b, glm::vec3 c, float step, F f) {
  const float ab = glm::length(b - a), bc = glm::length(c - b), ca = glm::length(a - c);
  if (bc >= ab && bc >= ca)
    std::tie(a, b, c) = std::tuple(b, c, a);
  else if (ca >= ab)
    std::tie(a, b, c) = std::tuple(c, a, b);
  const float base = glm::length(b - a);
  const float height = glm::length(glm::cross(b - a, c - a)) / base;
  const auto pieces = [step](float length) {
    return std::max(1, static_cast<int>(std::ceil(length / step)));
  };
  const int rows = pieces(height);
  for (int j = 0; j < rows; ++j) {
    const float v = (static_cast<float>(j) + 0.5f) / static_cast<float>(rows);
    const int columns = pieces(base * (1 - v));
    for (int i = 0; i < columns; ++i) {
      const float u = (static_cast<float>(i) + 0.5f) / static_cast<float>(columns);
      f(glm::mix(glm::mix(a, c, v), glm::mix(b, c, v), u));
    }
  }
}

/// The cell of a cubic grid with this edge (m) that a point lies in.
glm::ivec3 cube_of(const glm::vec3& point, float edge) {
  return glm::ivec3(glm::floor(point / edge));
}
/// The key of a cell, from the lowest 21 bits of each coordinate.
std::uint64_t number_of(const glm::ivec3& cube) {
  constexpr std::uint64_t mask = (1u << 21) - 1;
  const glm::u64vec3 c(cube);
  return (c.x & mask) << 42 | (c.y & mask) << 21 | (c.z & mask);
}

/// Places all over the surface, about `step` (m) apart. Where triangles are smaller than that, one
/// place stands for all those in a cell half a step wide that face the same octant.
std::vector<Place> cover(const TriangleSurface& surface, float step) {
  std::vector<Place> places;
  std::unordered_set<std::uint64_t> taken[8];
  for (const glm::uvec3& t : surface.triangles) {
    const glm::vec3 a = surface.vertices[t.x], b = surface.vertices[t.y], c = surface.vertices[t.z];
    const glm::vec3 normal = glm::cross(b - a, c - a);
    const float length = glm::length(normal);
    if (!(length > 0))
      continue;
    const int octant = (normal.x < 0) + 2 * (normal.y < 0) + 4 * (normal.z < 0);
    cover_triangle(a, b, c, step, [&](const glm::vec3& point) {
      if (taken[octant].insert(number_of(cube_of(point, 0.5f * step))).second)
        places.push_back({point, normal / length});
    });
  }
  return places;
}

/// The largest ball within the body that touches the surface at a place, up to a given radius.
struct Ball {
  glm::vec3 center;      ///< m
  float radius;          ///< m
  bool between = false;  ///< whether it also touches a side that faces the other way, as in a wall
};

/// Finds the ball of radius at most `most` (m) by shrinking (Ma, Bae & Choi 2012, "3D medial axis
/// point approximation using nearest neighbors and the normal field").
Ball largest_ball(const TriangleTree& tree, const Place& place, float most) {
  constexpr float nearly = 0.99f;
  Ball ball{place.point - most * place.normal, most};
  TriangleTree::Nearest other = tree.nearest(ball.center);
  glm::vec3 touched = place.point;
  // In a very thin wall the first centre lies beyond the wall, hardly nearer to its other side.
  const bool beyond = tree.winding_number(ball.center) == 0;
  for (int k = 0; k < 30 && (other.distance < nearly * ball.radius || (beyond && k == 0)); ++k) {
    touched = other.point;
    const glm::vec3 across = place.point - touched;
    const float smaller = glm::dot(across, across) / (2 * glm::dot(place.normal, across));
    if (!(smaller > 0 && smaller < nearly * ball.radius))
      break;
    ball.radius = smaller;
    ball.center = place.point - smaller * place.normal;
    other = tree.nearest(ball.center, other.triangle);
  }
  const glm::vec3 out = touched - ball.center;
  ball.between = glm::dot(place.normal, out) < -0.5f * glm::length(out);
  return ball;
}

/// The sample of a place on the surface: half a spacing below it or, in a thin wall, in its middle;
/// nullopt where the wall has hardly any thickness.
std::optional<Candidate> settle(const TriangleTree& tree, const Place& place, float spacing) {
  const float inset = 0.5f * spacing;
  const glm::vec3 below = place.point - inset * place.normal;
  const Ball ball = largest_ball(tree, place, two_layers * inset);
  if (ball.radius < 1e-3f * inset)
    return std::nullopt;
  if (ball.between && ball.radius < one_layer * inset)
    return Candidate{{ball.center, SurfaceSample::Side::both, place.normal}, place.normal};
  if (ball.between)
    return Candidate{{below, SurfaceSample::Side::one, place.normal}, place.normal};
  if (ball.radius >= inset)
    return Candidate{{below}, place.normal};

  // Two sides meet at an angle, as at the edges of a box: the sample moves away from both, as far
  // as there is room. A step is shorter than the distance to the surface, so it stays in the body.
  Candidate roomiest{{ball.center, SurfaceSample::Side::both, place.normal}, place.normal};
  glm::vec3 center = ball.center;
  float room = 0;
  std::uint32_t guess = 0;
  for (int k = 0; k < 20; ++k) {
    const TriangleTree::Nearest side = tree.nearest(center, guess);
    guess = side.triangle;
    if (!(side.distance > 0))
      break;
    const glm::vec3 out = (side.point - center) / side.distance;
    if (side.distance > room) {
      room = side.distance;
      roomiest.sample.position = center;
      roomiest.normal = out;
    }
    const float missing = inset - side.distance;
    if (std::abs(missing) < 0.01f * inset) {
      roomiest.sample = {center};
      break;
    }
    center -= std::min(missing, 0.5f * side.distance) * out;
  }
  // On a box, samples at edges and corners have moved 1.4 and 1.7 times as far as those on faces.
  const float moved = glm::distance(place.point, roomiest.sample.position) / inset;
  roomiest.sides = moved > 1.55f ? 3 : moved > 1.2f ? 2 : 1;
  return roomiest;
}

/// A hash grid that finds the candidates near a point.
class CandidateGrid {
 public:
  CandidateGrid(const std::vector<Candidate>& candidates, float edge) : edge_(edge) {
    for (std::uint32_t k = 0; k < candidates.size(); ++k)
      cubes_[number_of(cube_of(candidates[k].sample.position, edge))].push_back(k);
  }

  /// Calls f(k) with the index of every candidate that may be within a cell's edge of the point.
  template <class F>
  void for_each_near(const glm::vec3& point, F f) const {
    const glm::ivec3 cube = cube_of(point, edge_);
    for (int z = -1; z <= 1; ++z)
      for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
          const auto found = cubes_.find(number_of(cube + glm::ivec3(x, y, z)));
          if (found != cubes_.end())
            for (const std::uint32_t k : found->second)
              f(k);
        }
  }

 private:
  float edge_;
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> cubes_;
};

/// Chooses samples among the candidates so that no two are nearer than their least distance, and no
/// candidate is farther than that from a chosen one; samples in the two layers of a wall may be
/// nearer. Corners come first, then edges, then faces. The choice grows from sample to sample,
/// nearest first, so that samples lie closely, row by row.
class Thinning {
 public:
  Thinning(const std::vector<Candidate>& candidates, float spacing)
      : candidates_(candidates),
        spacing_(spacing),
        grid_(candidates, 1.5f * least_distance * spacing),
        covered_(candidates.size(), false) {
    for (const int sides : {3, 2, 1}) {
      std::size_t grown = 0;
      for (std::uint32_t start = 0; start < candidates.size(); ++start) {
        if (is_free(start, sides))
          choose(start);
        for (; grown < chosen_.size(); ++grown)
          choose_around(chosen_[grown], sides);
      }
    }
  }

  const std::vector<std::uint32_t>& chosen() const { return chosen_; }

 private:
  bool is_free(std::uint32_t k, int sides) const {
    return !covered_[k] && candidates_[k].sides >= sides;
  }

  float distance(std::uint32_t j, std::uint32_t k) const {
    return glm::distance(candidates_[j].sample.position, candidates_[k].sample.position);
  }

  void choose(std::uint32_t k) {
    chosen_.push_back(k);
    const Candidate& candidate = candidates_[k];
    const bool single = candidate.sample.side == SurfaceSample::Side::both;
    const float least = spacing_ * (single ? least_distance_single : least_distance);
    grid_.for_each_near(candidate.sample.position, [&](std::uint32_t other) {
      if (distance(k, other) < least && !are_two_layers(candidate, candidates_[other]))
        covered_[other] = true;
    });
  }

  static bool are_two_layers(const Candidate& a, const Candidate& b) {
    return a.sample.side != SurfaceSample::Side::both &&
           b.sample.side != SurfaceSample::Side::both && glm::dot(a.normal, b.normal) < -0.5f;
  }

  void choose_around(std::uint32_t center, int sides) {
    std::vector<std::pair<float, std::uint32_t>> around;
    grid_.for_each_near(candidates_[center].sample.position, [&](std::uint32_t k) {
      if (is_free(k, sides))
        around.push_back({distance(center, k), k});
    });
    std::sort(around.begin(), around.end());
    for (const auto& [away, k] : around)
      if (is_free(k, sides))
        choose(k);
  }

  const std::vector<Candidate>& candidates_;
  float spacing_;
  CandidateGrid grid_;
  std::vector<bool> covered_;
  std::vector<std::uint32_t> chosen_;
};

}  // namespace

std::vector<SurfaceSample> sample_mesh(const TriangleSurface& surface, const TriangleTree& tree,
                                       float spacing) {
  const std::vector<Place> places = cover(surface, 0.25f * spacing);
  std::vector<std::optional<Candidate>> settled(places.size());
#pragma omp parallel for schedule(dynamic, 256)
  for (std::size_t k = 0; k < places.size(); ++k)
    settled[k] = settle(tree, places[k], spacing);
  std::vector<Candidate> candidates;
  for (const std::optional<Candidate>& candidate : settled)
    if (candidate)
      candidates.push_back(*candidate);
  const Thinning thinning(candidates, spacing);
  std::vector<SurfaceSample> samples;
  for (const std::uint32_t k : thinning.chosen())
    samples.push_back(candidates[k].sample);
  return samples;
}

}  // namespace spindrift::geometry
