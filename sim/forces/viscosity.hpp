// Viscosity, explicit where the time step size is small enough for that, implicit where it is not.
// Both use the same operator, so that a scene looks the same with either.
#pragma once

#include "sim/forces/force.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// The viscosity of a scene; null where neither the liquid nor any wall or obstacle has one.
std::unique_ptr<Force> make_viscosity(const Settings& settings, const FluidConstants& constants);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
