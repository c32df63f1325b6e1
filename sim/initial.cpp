#include "sim/initial.hpp"

#include <algorithm>
#include <cmath>

#include "sim/formulas.hpp"
#include "sim/lattice.hpp"
#include "sim/shapes.hpp"

namespace spindrift::sim {

InitialParticles fill_volumes(const Settings& settings) {
  InitialParticles initial;
  for (const Volume& volume : settings.fluid.volumes) {
    const auto points = fill_shape(volume.shape, settings.fluid.spacing);
    initial.positions.insert(initial.positions.end(), points.begin(), points.end());
    initial.velocities.insert(initial.velocities.end(), points.size(), volume.velocity);
  }
  return initial;
}

FluidConstants constants_of(const FluidSettings& fluid) {
  const float radius = 2 * fluid.spacing;
  const CubicKernel kernel(radius);
  return {.spacing = fluid.spacing,
          .support_radius = radius,
          .rest_density = fluid.rest_density,
          .volume = static_cast<float>(1 / lattice_kernel_sum(kernel, fluid.spacing, radius)),
          .viscosity = fluid.viscosity,
          .wall_viscosity = fluid.wall_viscosity,
          .surface_tension = fluid.surface_tension,
          .contact_angle = fluid.contact_angle};
}

float default_speed_of_sound(const Settings& settings, const InitialParticles& initial) {
  float speed = 0;
  for (const glm::vec3 v : initial.velocities)
    speed = std::max(speed, glm::length(v));
  float acceleration = glm::length(settings.forces.gravity);
  for (const AccelerationKey& k : settings.forces.body)
    acceleration += glm::length(k.acceleration);
  const glm::vec3 size = settings.domain.max - settings.domain.min;
  const glm::vec3 down = glm::abs(settings.forces.gravity);
  const float height =
      glm::length(down) > 0 ? glm::dot(size, down) / glm::length(down) : glm::length(size);
  const FluidSettings& fluid = settings.fluid;
  const float capillary = 2 * fluid.surface_tension / (fluid.rest_density * fluid.spacing);
  return 10 * std::max(std::sqrt(speed * speed + 2 * acceleration * height + capillary), 1e-3f);
}

}  // namespace spindrift::sim
