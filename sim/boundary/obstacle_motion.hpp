// Obstacles that move among those that stand still.
#pragma once

#include <vector>

#include "sim/core/settings.hpp"

namespace spindrift::sim {

/// Where an obstacle is at a time, s; one that is fixed is where the scene puts it.
Pose pose_at(const Obstacle& obstacle, double time);

/// Whether any obstacle moves.
bool any_moves(const std::vector<Obstacle>& obstacles);

/// The settings without the obstacles that move.
Settings without_moving(const Settings& settings);

/// About the fastest speed that any point of an obstacle reaches, m/s; 0 if it is fixed.
float fastest_speed(const Obstacle& obstacle);

}  // namespace spindrift::sim
