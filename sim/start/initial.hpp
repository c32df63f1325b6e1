// What a run starts with: the particles that fill a scene's volumes, the grid of cells, and the
// constants of the fluid.
#pragma once

#include <vector>

#include "sim/core/frame.hpp"
#include "sim/core/settings.hpp"
#include "sim/core/stop.hpp"

namespace spindrift::sim {

/// The fluid particles of a scene at the start.
/// @throws Stopped
InitialParticles fill_volumes(const Settings& settings, Stop stop = nullptr);

/// What fill_volumes() would return as `volumes`, without computing the particles.
std::vector<FilledVolume> count_volumes(const Settings& settings);

/// The number of particles that fill_volumes() makes.
std::size_t initial_particle_count(const Settings& settings);

/// The settings with particle_spacing() in place of the spacing that they ask for.
Settings as_filled(const Settings& settings);

struct GridMap;
/// The grid over all places where particles may be, nozzles and the reach beyond open faces
/// included.
/// @param cell edge of a cell, m
GridMap grid_over(const Settings& settings, float cell);

struct FluidConstants;
/// The constants of the equations of motion, of which some follow from the spacing.
FluidConstants constants_of(const FluidSettings& fluid);

/// The speed of sound for basic SPH where the settings give none, m/s: ten times an estimate of the
/// highest speed, from those of the volumes, the obstacles and the emitters, a fall
/// through the whole domain, and surface tension.
float default_speed_of_sound(const Settings& settings);

}  // namespace spindrift::sim
