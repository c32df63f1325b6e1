// What a run starts with: the particles that fill a scene's volumes, and the numbers that stay the
// same.
#pragma once

#include <vector>

#include "sim/core/frame.hpp"
#include "sim/core/settings.hpp"
#include "sim/core/stop.hpp"

namespace spindrift::sim {

/// The particles that a scene is filled with.
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

/// Ten times the fastest speed that falling through the whole domain can give, m/s.
float default_speed_of_sound(const Settings& settings, const InitialParticles& initial);

}  // namespace spindrift::sim
