// Where a body that moves on a script is at a time.
#pragma once

#include <glm/glm.hpp>

#include "sim/settings.hpp"

namespace spindrift::sim {

/// Takes points from where the scene puts a body to where it is.
struct Pose {
  glm::dmat3 rotation{1.};
  glm::dvec3 translation{0.};  ///< m

  glm::dvec3 operator()(const glm::dvec3& p) const { return rotation * p + translation; }
};

/// Depends on the time (s) alone.
Pose pose_at(const Motion& motion, double time);

/// The same for an obstacle that may be fixed.
Pose pose_at(const Obstacle& obstacle, double time);

/// The smallest box around where a box is in a pose, m.
Box bounds_at(const Pose& pose, const Box& box);

/// Whether any obstacle moves.
bool any_moves(const std::vector<Obstacle>& obstacles);

/// The settings without the obstacles that move.
Settings without_moving(const Settings& settings);

/// About the fastest speed that any point of an obstacle reaches, m/s; 0 if it is fixed.
float fastest_speed(const Obstacle& obstacle);

}  // namespace spindrift::sim
