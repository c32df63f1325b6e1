// The particles' state to and from what a run starts with and what it gives.
#pragma once

#include "sim/backend/backend.hpp"
#include "sim/core/frame.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Takes over the particles of a start, numbered from 0.
void set_particles(Executor& executor, Particles& particles, const InitialParticles& initial);

/// Takes over those of a frame.
void set_particles(Executor& executor, Particles& particles, const Frame& frame);

/// The particles' part of a frame, on its way.
struct ParticleCopies {
  Copy<glm::vec3> positions, velocities;
  Copy<float> densities, pressures, multipliers;
  Copy<std::uint32_t> ids;

  void put_into(Frame& frame);
};

/// Copies the particles as they are now. @param rest_density kg/m³
ParticleCopies copy_particles(Executor& executor, Particles& particles, float rest_density);

/// m/s.
float largest_speed(Executor& executor, Particles& particles);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
