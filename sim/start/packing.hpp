// Spreads particles evenly where a body cuts through their initial lattice.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim/core/stop.hpp"
#include "sim/start/standing_bodies.hpp"

namespace spindrift::sim {

/// A particle that pack() may move.
struct PackedParticle {
  std::uint32_t number;  ///< index into the positions
  glm::vec3 axes;        ///< 1 for each axis along which it may move, else 0
};

/// Moves particles so that they are spread evenly among the others and the solids, as a pressure
/// that is the same everywhere would do (Colagrossi, Bouscasse, Antuono, Marrone 2012): Σ ∇W over
/// all neighbours decreases. No particle ends in a body.
/// @param positions of all particles, m
/// @param moves the particles that may move
/// @param walls boundary particles of nearby walls and bodies, each counted as one particle, m
/// @param spacing of the particles, m
/// @throws Stopped
void pack(std::vector<glm::vec3>& positions, const std::vector<PackedParticle>& moves,
          const std::vector<glm::vec3>& walls, const StandingBodies& bodies, float spacing,
          Stop stop);

}  // namespace spindrift::sim
