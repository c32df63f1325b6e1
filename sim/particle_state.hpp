// The particles' state to and from what a run starts with and what it gives.
#pragma once

#include "sim/backend.hpp"
#include "sim/initial.hpp"
#include "sim/particles.hpp"
#include "sim/simulation.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Takes over the particles of a start, numbered from 0.
void set_particles(Executor& executor, Particles& particles, const InitialParticles& initial);

/// Takes over those of a frame.
void set_particles(Executor& executor, Particles& particles, const Frame& frame);

/// Puts the particles into a frame. @param rest_density kg/m³
void put_particles(const Particles& particles, float rest_density, Frame& frame);

/// m/s.
float largest_speed(Executor& executor, Particles& particles);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
