// The scripted rigid motion of a body by keyframes, oscillations and spin, and its pose at a time.
#pragma once

#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "sim/geometry/shapes/box.hpp"

namespace spindrift::geometry {

/// A keyframe: a body's displacement from where the scene places it, at one time.
struct MotionKey {
  float time = 0.f;          ///< s
  glm::vec3 translate{0.f};  ///< m
  glm::vec3 rotate{0.f};     ///< angles about x, then y, then z, through the pivot, degrees
};

/// How a motion goes from one keyframe to the next: along a monotone cubic or a straight line.
enum class Interpolation { smooth, linear };

/// A harmonic oscillation: the amplitudes times sin(2π · frequency · time + phase).
struct Oscillation {
  glm::vec3 translate{0.f};  ///< amplitude of the translation, m
  glm::vec3 rotate{0.f};     ///< amplitude of the angles about x, then y, then z, degrees
  float frequency = 1.f;     ///< Hz
  float phase = 0.f;         ///< phase at time 0, degrees
};

/// A rotation at constant angular speed about an axis through the pivot.
struct Spin {
  glm::vec3 axis{0.f, 1.f, 0.f};  ///< of any length; its tip sees the turn counter-clockwise
  float frequency = 0.5f;         ///< turns per second
};

/// The motion of a body as a function of time alone. The body first spins, then is rotated, both
/// about the pivot, and then is translated; the displacements of keyframes and oscillations add up.
struct Motion {
  glm::vec3 pivot{0.f};                                 ///< in the body as the scene places it, m
  std::vector<MotionKey> keyframes;                     ///< in ascending order of their times
  Interpolation interpolation = Interpolation::smooth;  ///< between keyframes; outside: at rest
  std::vector<Oscillation> oscillations;
  std::optional<Spin> spin = std::nullopt;
};

/// A rigid transformation from where the scene places a body to where the body is.
struct Pose {
  glm::dmat3 rotation{1.};
  glm::dvec3 translation{0.};  ///< m

  glm::dvec3 operator()(const glm::dvec3& p) const { return rotation * p + translation; }
};

/// The pose of a body at a time, s.
Pose pose_at(const Motion& motion, double time);

/// The smallest axis-aligned box around a box that a pose has moved, m.
Box bounds_at(const Pose& pose, const Box& box);

/// The rotation about the x, then the y, then the z axis by these angles, degrees.
glm::dmat3 rotation_by(const glm::dvec3& angles);

/// Estimates the highest speed that any point of a body within `bounds` reaches, m/s.
float fastest_speed(const Motion& motion, const Box& bounds);

}  // namespace spindrift::geometry
