#include "sim/forces/drag.hpp"
#include "sim/forces/force.hpp"
#include "sim/forces/surface_tension.hpp"
#include "sim/forces/viscosity.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

std::vector<std::unique_ptr<Force>> forces_of(const Settings& settings,
                                              const FluidConstants& constants) {
  std::vector<std::unique_ptr<Force>> forces;
  for (const auto make : {make_surface_tension, make_drag, make_viscosity})
    if (auto force = make(settings, constants))
      forces.push_back(std::move(force));
  return forces;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
