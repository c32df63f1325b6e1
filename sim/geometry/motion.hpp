// How a body moves on a script, and where it is at a time.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "sim/geometry/shapes/box.hpp"

namespace spindrift::geometry {

/// One key of a body's way, relative to where the scene puts it.
struct MotionKey {
  float time = 0.f;          ///< s
  glm::vec3 translate{0.f};  ///< m
  glm::vec3 rotate{0.f};     ///< about x, then y, then z, through the pivot, degrees
};

enum class Interpolation { smooth, linear };

/// A swing to and fro: amplitudes times sin(2π frequency time + phase).
struct Oscillation {
  glm::vec3 translate{0.f};  ///< amplitude, m
  glm::vec3 rotate{0.f};     ///< amplitude about x, then y, then z, degrees
  float frequency = 1.f;     ///< Hz
  float phase = 0.f;         ///< at time 0, degrees
};

/// A steady turn about an axis through the pivot.
struct Spin {
  glm::vec3 axis{0.f, 1.f, 0.f};  ///< counter-clockwise seen from its tip; need not be unit
  float frequency = 0.5f;         ///< turns per second
};

/// How a body moves: where it is depends on nothing but the time. It spins, is rotated, both about
/// the pivot, and is translated; the parts of keyframes and oscillations add up.
struct Motion {
  glm::vec3 pivot{0.f};                                 ///< where the scene puts it, m
  std::vector<MotionKey> keyframes;                     ///< in the order of their times
  Interpolation interpolation = Interpolation::smooth;  ///< between keys; before and after: at rest
  std::vector<Oscillation> oscillations;
  std::optional<Spin> spin = std::nullopt;
};

/// Takes points from where the scene puts a body to where it is.
struct Pose {
  glm::dmat3 rotation{1.};
  glm::dvec3 translation{0.};  ///< m

  glm::dvec3 operator()(const glm::dvec3& p) const { return rotation * p + translation; }
};

/// Depends on the time (s) alone.
Pose pose_at(const Motion& motion, double time);

/// The smallest box around where a box is in a pose, m.
Box bounds_at(const Pose& pose, const Box& box);

/// A rotation about the x, then the y, then the z axis by angles in degrees.
glm::dmat3 rotation_by(const glm::dvec3& angles);

/// About the fastest speed that any point of a body in a box reaches, m/s.
float fastest_speed(const Motion& motion, const Box& bounds);

}  // namespace spindrift::geometry
