// The nozzle of an emitter: layers of particles that it pushes out one after the other. All is a
// function of time and has no state, so that a resumed run does the same as one without a break.
//
//   opening
//      |  · · · · |            The coordinate a is along the emitter's direction, 0 at the opening.
//      |  · · · · |  →         Layer k is at a(t) = v (t − from) − (k + ½) b, with b the distance
//   depth         0            between layers. It enters the nozzle at a = −depth = −4 b and is
//                              released at a = 0.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/core/settings.hpp"
#include "sim/geometry/host_device.hpp"

namespace spindrift::sim {

struct CubicKernel;

/// The points of an emitter's opening through which particles come, each of which represents the
/// same share of the opening's area.
struct OpeningPoints {
  std::vector<glm::vec3> points;  ///< m
  float layer_distance = 0;       ///< between layers that follow each other, m
};
/// Distributes N points over an opening of area A, about a spacing d (m) apart: a point's share is
/// A/N, and the layer distance d³/(A/N) gives each particle the volume d³.
OpeningPoints fill_opening(const Opening& opening, float spacing);

/// The area of an opening, m².
double opening_area(const Opening& opening);

/// The direction in which liquid leaves an opening, of unit length.
glm::vec3 direction_of(const Opening& opening);

/// The position of a particle that a nozzle moves, m.
/// @param point the particle's point in the opening, m
/// @param way its distance from the opening along the direction, m; negative in the nozzle
SPINDRIFT_HD inline glm::vec3 pushed(const glm::vec3& point, const glm::vec3& direction,
                                     double way) {
  return glm::vec3(glm::dvec3(point) + way * glm::dvec3(direction));
}

/// The layers of one emitter, numbered from 0 in the order in which they come. A layer enters the
/// nozzle, is carried to the opening, and is released there.
class Nozzle {
 public:
  static constexpr int depth = 4;  ///< length of the nozzle, in layers

  /// @param spacing of the particles, m
  Nozzle(const Emitter& emitter, float spacing);

  /// The number of particles in a layer.
  std::uint32_t layer_size() const { return static_cast<std::uint32_t>(points_.size()); }
  /// The number of layers that the emitter brings in all.
  std::int64_t layer_count() const { return layer_count_; }

  /// The time at which layer k enters the nozzle, s. The first four layers are in it from the
  /// beginning of the emitter.
  double entry_time(std::int64_t k) const;
  /// The time at which layer k leaves the nozzle, s.
  double release_time(std::int64_t k) const;
  /// The time at which the emitter begins, s.
  double begin() const { return begin_; }
  /// The number of layers that have entered the nozzle by a time (s), at that time included.
  std::int64_t entered(double time) const;
  /// The number of layers that have left the nozzle by a time (s), at that time included.
  std::int64_t released(double time) const;
  /// The number of layers that have entered the nozzle before a time, s.
  std::int64_t entered_before(double time) const;

  /// The position of a particle of layer k when nothing but the nozzle moves it, m.
  /// @param point the particle's index within the layer
  glm::vec3 position(std::int64_t k, std::uint32_t point, double time) const;
  glm::vec3 velocity() const { return velocity_; }  ///< m/s
  /// The distance of layer k from the opening at a time (s), m; negative in the nozzle.
  double way(std::int64_t k, double time) const { return (time - release_time(k)) * speed_; }
  /// The points of a layer's particles in the opening, m.
  const std::vector<glm::vec3>& points() const { return points_; }
  const glm::vec3& direction() const { return direction_; }
  float layer_distance() const { return static_cast<float>(distance_); }  ///< m

  /// The fraction to which a wall around the nozzle is closed at a time, s: 1 before the emitter
  /// begins, 0 while liquid is in the nozzle, and from then on growing to 1, the faster the faster
  /// the liquid was.
  double closed_part(double time) const;
  /// Whether a boundary particle at p (m) is in the way of the liquid in the nozzle.
  bool is_in_the_way(const glm::vec3& p) const;
  /// Σ W at a point (m) over the particles in the full nozzle, at the moment when it is largest as
  /// layers go by, 1/m³.
  double kernel_sum(const glm::vec3& p, const CubicKernel& kernel) const;
  /// Σ W at a point (m) over the particles in the nozzle when it has just opened, 1/m³.
  double kernel_sum_at_begin(const glm::vec3& p, const CubicKernel& kernel) const;
  /// The middle of the points in the opening, and their largest distance from it, m.
  std::pair<glm::vec3, float> opening_ball() const;
  /// Two directions at right angles to the nozzle's and to each other.
  std::pair<glm::vec3, glm::vec3> axes_across() const;
  /// The highest speed in the nozzle between two times (s), m/s.
  float speed_within(double begin, double end) const;
  /// The bounding box of the nozzle's particles, from the opening to its depth, m.
  Box bounds() const;

 private:
  double kernel_sum_with(const glm::vec3& p, const CubicKernel& kernel, double first) const;

  double begin_ = 0, speed_ = 0;  ///< s, m/s
  double distance_ = 0;           ///< between two layers, m
  float reach_ = 0;               ///< how far a particle reaches across the direction, m
  std::int64_t layer_count_ = 0;
  std::vector<glm::vec3> points_;  ///< in the opening, m
  glm::vec3 direction_{0.f}, velocity_{0.f};
};

}  // namespace spindrift::sim
