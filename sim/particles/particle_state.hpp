// Moves the particles' state from initial particles and frames into a backend's fields, and from
// the fields into frames.
#pragma once

#include "sim/backend/backend.hpp"
#include "sim/core/frame.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Replaces all particles by the initial ones of a run, with ids from 0 on.
void set_particles(Executor& executor, Particles& particles, const InitialParticles& initial);

/// Replaces all particles by those of a frame.
void set_particles(Executor& executor, Particles& particles, const Frame& frame);

/// The per-particle arrays of a frame, which may still be on their way from the device.
struct ParticleCopies {
  Copy<glm::vec3> positions, velocities;
  Copy<float> densities, pressures, constraint_multipliers;
  Copy<std::uint32_t> ids;

  /// Moves the arrays into a frame, once; waits until they have arrived.
  void put_into(Frame& frame);
};

/// Begins to copy the particles as they are now. @param rest_density kg/m³
ParticleCopies copy_particles(Executor& executor, Particles& particles, float rest_density);

/// The largest speed of any particle, m/s.
float largest_speed(Executor& executor, Particles& particles);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
