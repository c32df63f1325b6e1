// Adds particles to those there are, and takes some away.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>

#include "sim/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Adds particles of the given velocity, m/s, without pressure, after all others.
void append_particles(Particles& particles, std::span<const glm::vec3> positions,
                      const glm::vec3& velocity, std::span<const std::uint32_t> ids);

/// Takes away particle i where gone[i] is not 0; the others keep their order.
void remove_particles(Particles& particles, std::span<const std::uint8_t> gone);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
