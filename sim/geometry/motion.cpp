#include "sim/geometry/motion.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "sim/geometry/keyframes.hpp"

namespace spindrift::geometry {
namespace {

/// The displacement by keyframes and oscillations, without the spin.
struct Displacement {
  glm::dvec3 translate{0.};  ///< m
  glm::dvec3 rotate{0.};     ///< degrees
};

Displacement displacement_at(const Motion& motion, double time) {
  Displacement d;
  if (!motion.keyframes.empty()) {
    const auto n = numbers_at(
        motion.keyframes, time,
        [](const MotionKey& k) {
          return std::array{k.translate.x, k.translate.y, k.translate.z,
                            k.rotate.x,    k.rotate.y,    k.rotate.z};
        },
        motion.interpolation == Interpolation::linear);
    d = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
  }
  for (const Oscillation& o : motion.oscillations) {
    const double swing = std::sin(2 * std::numbers::pi * o.frequency * time +
                                  glm::radians(static_cast<double>(o.phase)));
    d.translate += swing * glm::dvec3(o.translate);
    d.rotate += swing * glm::dvec3(o.rotate);
  }
  return d;
}

}  // namespace

glm::dmat3 rotation_by(const glm::dvec3& angles) {
  glm::dmat4 turn(1.);
  for (const int axis : {2, 1, 0}) {
    glm::dvec3 direction(0.);
    direction[axis] = 1.;
    turn = glm::rotate(turn, glm::radians(angles[axis]), direction);
  }
  return glm::dmat3(turn);
}

Pose pose_at(const Motion& motion, double time) {
  const Displacement d = displacement_at(motion, time);
  glm::dmat4 turn(rotation_by(d.rotate));
  if (motion.spin)
    turn = glm::rotate(turn, 2 * std::numbers::pi * motion.spin->frequency * time,
                       glm::dvec3(motion.spin->axis));
  const glm::dvec3 pivot(motion.pivot);
  Pose pose{glm::dmat3(turn), {}};
  pose.translation = pivot + d.translate - pose.rotation * pivot;
  return pose;
}

Box bounds_at(const Pose& pose, const Box& box) {
  Box posed{glm::vec3(INFINITY), glm::vec3(-INFINITY)};
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 p(
        pose(glm::dvec3((corner & 1) ? box.max.x : box.min.x, (corner & 2) ? box.max.y : box.min.y,
                        (corner & 4) ? box.max.z : box.min.z)));
    posed = {glm::min(posed.min, p), glm::max(posed.max, p)};
  }
  return posed;
}

float fastest_speed(const Motion& motion, const Box& bounds) {
  const float radius = glm::length(
      glm::max(glm::abs(bounds.min - motion.pivot), glm::abs(bounds.max - motion.pivot)));
  const auto length = [&](const glm::vec3& translate, const glm::vec3& rotate) {
    return glm::length(translate) + radius * glm::length(glm::radians(rotate));
  };
  float keyed = 0;
  for (std::size_t i = 1; i < motion.keyframes.size(); ++i) {
    const MotionKey &a = motion.keyframes[i - 1], &b = motion.keyframes[i];
    keyed =
        std::max(keyed, length(b.translate - a.translate, b.rotate - a.rotate) / (b.time - a.time));
  }
  if (motion.interpolation == Interpolation::smooth)
    keyed *= 1.5f;  // the cubic's largest slope by its mean with two keys alone; up to 2 with more
  const float turn = 2 * std::numbers::pi_v<float>;
  float speed = keyed;
  for (const Oscillation& o : motion.oscillations)
    speed += turn * std::abs(o.frequency) * length(o.translate, o.rotate);
  return speed + (motion.spin ? turn * std::abs(motion.spin->frequency) * radius : 0.f);
}

}  // namespace spindrift::geometry
