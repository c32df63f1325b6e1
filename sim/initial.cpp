#include "sim/initial.hpp"

#include <algorithm>
#include <cmath>

#include "sim/cells.hpp"
#include "sim/fluid_constants.hpp"
#include "sim/from_glm.hpp"
#include "sim/kernels.hpp"
#include "sim/lattice.hpp"
#include "sim/motion.hpp"
#include "sim/nozzle.hpp"
#include "sim/outflow.hpp"
#include "sim/posed_body.hpp"
#include "sim/shapes.hpp"

namespace spindrift::sim {

namespace {

/// Whether a particle would start in a body that moves, or closer to it than half a spacing.
bool is_taken(const std::vector<PosedBody>& bodies, const glm::vec3& p, float spacing) {
  for (const PosedBody& body : bodies)
    for (int axis = 0; axis < 3; ++axis)
      for (const float side : {-0.49f, 0.49f}) {
        glm::vec3 edge = p;
        edge[axis] += side * spacing;
        if (body.depth(from_glm(edge)) > 0)
          return true;
      }
  return false;
}

}  // namespace

InitialParticles fill_volumes(const Settings& settings) {
  InitialParticles initial;
  const std::vector<PosedBody> bodies = posed_bodies(settings, 0, 0);
  for (const Volume& volume : settings.fluid.volumes) {
    auto points = fill_shape(volume.shape, settings.fluid.spacing);
    if (!bodies.empty())
      std::erase_if(
          points, [&](const glm::vec3& p) { return is_taken(bodies, p, settings.fluid.spacing); });
    initial.positions.insert(initial.positions.end(), points.begin(), points.end());
    initial.velocities.insert(initial.velocities.end(), points.size(), volume.velocity);
  }
  return initial;
}

GridMap grid_over(const Settings& settings, float cell) {
  const float spacing = settings.fluid.spacing;
  Box box = reach_of(settings);
  for (const Emitter& emitter : settings.fluid.emitters) {
    const Box nozzle = Nozzle(emitter, spacing).bounds();
    box = {glm::min(box.min, nozzle.min), glm::max(box.max, nozzle.max)};
  }
  return GridMap::over(from_glm(box.min - spacing), from_glm(box.max + spacing), cell);
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

float largest_wall_viscosity(const Settings& settings) {
  float largest = settings.fluid.wall_viscosity;
  for (const Obstacle& obstacle : settings.obstacles)
    largest = std::max(largest, obstacle.wall_viscosity.value_or(0));
  return largest;
}

float default_speed_of_sound(const Settings& settings, const InitialParticles& initial) {
  float speed = 0;
  for (const glm::vec3 v : initial.velocities)
    speed = std::max(speed, glm::length(v));
  for (const Obstacle& obstacle : settings.obstacles)
    speed = std::max(speed, fastest_speed(obstacle));
  for (const Emitter& emitter : settings.fluid.emitters)
    speed = std::max(speed, emitter.speed);
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
