// Lessens the boundary particles beside a nozzle so that they do not compress the liquid that
// passes.
#pragma once

#include <vector>

#include "sim/flow/nozzle.hpp"

namespace spindrift::sim {

/// A boundary particle of a wall or an obstacle beside a nozzle.
struct RimSample {
  glm::vec3 position{0.f};  ///< m
  float volume = 0;         ///< m³
};

/// The boundary particles around a nozzle.
struct NozzleSamples {
  std::vector<RimSample> in_the_way;  ///< those that are gone while the nozzle is open
  std::vector<RimSample> beside;      ///< those that stay
};

/// Computes how much of its volume each boundary particle beside a nozzle keeps while the nozzle is
/// open. Boundary particles are placed without regard to the columns of particles that come through
/// a nozzle; where one is too close to a column, the liquid would come out compressed, by up to
/// 13 %. So their volumes shrink as far as needed for no particle to be denser than accepted on its
/// way from the inner end of the nozzle to beyond the wall, and for no liquid before the wall to be
/// denser than the closed wall makes it: otherwise that is compressed by up to 5 % when particles
/// take the place of the boundary particles in the way.
/// @param support_radius m
/// @param spacing of the fluid particles, m
/// @param particle_volume volume of a fluid particle, m³
/// @return for each of `samples.beside` the fraction of the volume that it keeps, 0 … 1
std::vector<float> parts_beside(const Nozzle& nozzle, const NozzleSamples& samples,
                                float support_radius, float spacing, float particle_volume);

}  // namespace spindrift::sim
