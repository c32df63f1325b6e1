// Layers of particles that an emitter pushes out, one after the other, as functions of time: no
// state, so that a run that is gone on with does the same.
//
//   opening
//      |  · · · · |            a = 0 at the opening, along the emitter's direction. Layer k is at
//      |  · · · · |  →           a(t) = v (t − from) − (k + ½) b,   b the distance of two layers.
//   depth         0            It enters at −depth, 4 b, and is released at 0.
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "sim/core/settings.hpp"
#include "sim/geometry/host_device.hpp"

namespace spindrift::sim {

struct CubicKernel;

/// The points in an emitter's opening through which particles come, so that each stands for the
/// same share of its area; m. About a spacing apart: A/N = b², and layers follow each other as the
/// particle's volume wants it, d³/b².
struct OpeningPoints {
  std::vector<glm::vec3> points;
  float layer_distance = 0;  ///< m
};
OpeningPoints fill_opening(const Opening& opening, float spacing);

/// Area of an opening, m².
double opening_area(const Opening& opening);

/// Of unit length.
glm::vec3 direction_of(const Opening& opening);

/// Where a particle in a nozzle is, m.
/// @param point in the opening @param way from the opening on, m
SPINDRIFT_HD inline glm::vec3 pushed(const glm::vec3& point, const glm::vec3& direction,
                                     double way) {
  return glm::vec3(glm::dvec3(point) + way * glm::dvec3(direction));
}

class Nozzle {
 public:
  static constexpr int depth = 4;  ///< layers in the nozzle

  Nozzle(const Emitter& emitter, float spacing);

  std::uint32_t layer_size() const { return static_cast<std::uint32_t>(points_.size()); }
  /// Layers in all, from the first to the last.
  std::int64_t layer_count() const { return layer_count_; }

  /// When layer k comes into the nozzle and when out of it, s.
  double entry_time(std::int64_t k) const;
  double release_time(std::int64_t k) const;
  double begin() const { return begin_; }  ///< s
  /// How many layers are in the nozzle or have been, and how many have left it, at a time.
  std::int64_t entered(double time) const;
  std::int64_t released(double time) const;
  /// How many came in before a time.
  std::int64_t entered_before(double time) const;

  /// Where a particle of layer k is when nothing but the nozzle moves it, m.
  glm::vec3 position(std::int64_t k, std::uint32_t point, double time) const;
  glm::vec3 velocity() const { return velocity_; }  ///< m/s
  /// How far layer k has come from the opening, m; negative in the nozzle.
  double way(std::int64_t k, double time) const { return (time - release_time(k)) * speed_; }
  const std::vector<glm::vec3>& points() const { return points_; }  ///< m
  const glm::vec3& direction() const { return direction_; }
  float layer_distance() const { return static_cast<float>(distance_); }  ///< m

  /// How far the nozzle is closed again, as far as there is a wall around it: 0 while liquid is in
  /// it, and from then on growing up to 1, the faster the liquid was.
  double closed_part(double time) const;
  /// Whether a wall's sample is in the way of the liquid in the nozzle.
  bool is_in_the_way(const glm::vec3& p) const;
  /// Σ W over the particles in the full nozzle at a point, at the moment when it is largest as
  /// layers go by; 1/m³.
  double kernel_sum(const glm::vec3& p, const CubicKernel& kernel) const;
  /// The same when the nozzle has just opened.
  double kernel_sum_at_begin(const glm::vec3& p, const CubicKernel& kernel) const;
  /// The middle of the points in the opening, and how far from it they are at most, m.
  std::pair<glm::vec3, float> opening_ball() const;
  /// Two directions at right angles to the nozzle's and each other.
  std::pair<glm::vec3, glm::vec3> axes_across() const;
  /// The fastest speed in the nozzle in the time between, m/s.
  float speed_within(double begin, double end) const;
  /// The box around all particles in the nozzle.
  Box bounds() const;

 private:
  double kernel_sum_with(const glm::vec3& p, const CubicKernel& kernel, double first) const;

  double begin_ = 0, speed_ = 0;  ///< s, m/s
  double distance_ = 0;           ///< of two layers, m
  float reach_ = 0;               ///< of a particle across the direction, m
  std::int64_t layer_count_ = 0;
  std::vector<glm::vec3> points_;  ///< m
  glm::vec3 direction_{0.f}, velocity_{0.f};
};

}  // namespace spindrift::sim
