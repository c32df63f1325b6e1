// Queries about which obstacles of a scene move, and how.
#pragma once

#include <vector>

#include "sim/core/settings.hpp"

namespace spindrift::sim {

/// The pose of an obstacle at a time, s; a fixed obstacle stays where the scene places it.
Pose pose_at(const Obstacle& obstacle, double time);

/// Whether any obstacle moves.
bool any_moves(const std::vector<Obstacle>& obstacles);

/// The settings without the obstacles that move.
Settings without_moving(const Settings& settings);

/// Estimates the highest speed that any point of an obstacle reaches, m/s; 0 if it is fixed.
float fastest_speed(const Obstacle& obstacle);

}  // namespace spindrift::sim
