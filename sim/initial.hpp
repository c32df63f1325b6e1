// What a run starts with: the particles that fill a scene's volumes, and the numbers that stay the
// same.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <map>
#include <vector>

#include "sim/settings.hpp"
#include "sim/stop.hpp"

namespace spindrift::sim {

/// What became of the liquid that one volume asks for, in particles.
struct FilledVolume {
  std::size_t placed = 0;
  std::size_t outside = 0;                          ///< left out beyond the domain's faces
  std::map<std::size_t, std::size_t> in_obstacles;  ///< left out in those of the scene's obstacles
};

/// Positions, m, and velocities, m/s, of a scene's liquid at the start: its volumes, but for what
/// is outside of the domain, or taken up by an obstacle, fixed or moving.
struct InitialParticles {
  std::vector<glm::vec3> positions, velocities;
  std::vector<FilledVolume> volumes;  ///< in the order of the scene's
  std::vector<std::uint32_t> loose;   ///< particles that bodies have moved off their lattice
};
/// @throws Stopped
InitialParticles fill_volumes(const Settings& settings, Stop stop = nullptr);

/// What InitialParticles::volumes would be.
std::vector<FilledVolume> count_volumes(const Settings& settings);

/// The settings of the particles that a scene is filled with: with their spacing instead of the one
/// that is asked for; see particle_spacing().
Settings as_filled(const Settings& settings);

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
