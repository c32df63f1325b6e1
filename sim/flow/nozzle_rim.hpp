// What walls beside a nozzle stand for while liquid goes through it.
#pragma once

#include <vector>

#include "sim/flow/nozzle.hpp"

namespace spindrift::sim {

/// A sample of a wall or an obstacle beside a nozzle.
struct RimSample {
  glm::vec3 position{0.f};  ///< m
  float volume = 0;         ///< m³
};

/// The samples that a nozzle concerns.
struct NozzleSamples {
  std::vector<RimSample> in_the_way;  ///< gone while the nozzle is open
  std::vector<RimSample> beside;
};

/// Samples are placed without regard to the columns of particles that come through a nozzle. Where
/// one is too close to them, they would come out compressed, by up to 13 %; and liquid that stands
/// before the wall would be, by up to 5 %, when particles take the place of the samples in the way.
/// So samples beside a nozzle stand for less, as far as needed for no particle to be denser than it
/// may be on its way, from the nozzle's end to where it is beyond the wall, and for no liquid
/// before the wall to be denser than the closed wall makes it.
/// @param support_radius m @param spacing m @param particle_volume m³
/// @return the part of its volume that each sample beside the nozzle keeps, 0 ... 1
std::vector<float> parts_beside(const Nozzle& nozzle, const NozzleSamples& samples,
                                float support_radius, float spacing, float particle_volume);

}  // namespace spindrift::sim
