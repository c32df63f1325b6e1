// Particles spread evenly where a body cuts through their lattice.
#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "sim/core/stop.hpp"
#include "sim/start/standing_bodies.hpp"

namespace spindrift::sim {

struct PackedParticle {
  std::uint32_t number;  ///< among the positions
  glm::vec3 axes;        ///< 1 for those along which it may move, else 0
};

/// Moves particles to where they are spread evenly among others and solids, as a pressure that is
/// the same everywhere would (Colagrossi, Bouscasse, Antuono, Marrone 2012): Σ ∇W over all of them
/// falls. None ends in a body.
/// @param positions m @param moves those that move
/// @param walls samples of walls and bodies near them, each as one particle, m
/// @param spacing of the particles, m
/// @throws Stopped
void pack(std::vector<glm::vec3>& positions, const std::vector<PackedParticle>& moves,
          const std::vector<glm::vec3>& walls, const StandingBodies& bodies, float spacing,
          Stop stop);

}  // namespace spindrift::sim
