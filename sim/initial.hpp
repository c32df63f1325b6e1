// What a run starts with: the particles that fill a scene's volumes, and the numbers that stay the
// same.
#pragma once

#include <glm/glm.hpp>
#include <vector>

#include "sim/settings.hpp"

namespace spindrift::sim {

/// Lattice positions, m, and velocities, m/s, of a scene's volumes, but for what an obstacle that
/// moves takes up at the start.
struct InitialParticles {
  std::vector<glm::vec3> positions, velocities;
};
InitialParticles fill_volumes(const Settings& settings);

struct GridMap;
/// The grid of all places where particles may be. @param cell edge of a cell, m
GridMap grid_over(const Settings& settings, float cell);

struct FluidConstants;
FluidConstants constants_of(const FluidSettings& fluid);

/// With which any wall or obstacle holds the liquid back at most, Pa·s.
float largest_wall_viscosity(const Settings& settings);

/// Ten times the fastest speed that falling through the whole domain can give, m/s.
float default_speed_of_sound(const Settings& settings, const InitialParticles& initial);

}  // namespace spindrift::sim
