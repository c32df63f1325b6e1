#include "sim/boundary/obstacle_motion.hpp"

#include <algorithm>

namespace spindrift::sim {

Pose pose_at(const Obstacle& obstacle, double time) {
  return obstacle.motion ? geometry::pose_at(*obstacle.motion, time) : Pose{};
}

bool any_moves(const std::vector<Obstacle>& obstacles) {
  return std::any_of(obstacles.begin(), obstacles.end(),
                     [](const Obstacle& o) { return o.motion.has_value(); });
}

Settings without_moving(const Settings& settings) {
  Settings fixed = settings;
  std::erase_if(fixed.obstacles, [](const Obstacle& o) { return o.motion.has_value(); });
  return fixed;
}

float fastest_speed(const Obstacle& obstacle) {
  return obstacle.motion ? geometry::fastest_speed(*obstacle.motion, bounds_of(obstacle.shape)) : 0;
}

}  // namespace spindrift::sim
