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

/// Samples are placed without regard to the columns of particles that come through a nozzle. Where
/// one is too close to them, they would come out compressed, by up to 13 %. So samples beside a
/// nozzle stand for less, as far as needed for no particle to be denser than it may be on its way,
/// from the nozzle's end to where it is beyond the wall.
/// @param support_radius m @param particle_volume m³
/// @return the part of its volume that each sample keeps, 0 ... 1
std::vector<float> parts_beside(const Nozzle& nozzle, const std::vector<RimSample>& samples,
                                float support_radius, float particle_volume);

}  // namespace spindrift::sim
