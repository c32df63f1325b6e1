#include "sim/step/measure.hpp"

#include <algorithm>
#include <cmath>

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// Sums and maxima over the particles.
struct Totals {
  double compression = 0, squared_speed = 0, height = 0, squared_pressure = 0;
  float max_compression = 0;
  SPINDRIFT_HD void join(const Totals& o) {
    compression += o.compression;
    squared_speed += o.squared_speed;
    height += o.height;
    squared_pressure += o.squared_pressure;
    max_compression = std::max(max_compression, o.max_compression);
  }
};

/// The domain's corner in which nothing can fall any further, m.
Vec3<float> lowest_corner(const Settings& settings) {
  const glm::vec3 g = settings.forces.gravity, min = settings.domain.min, max = settings.domain.max;
  return {g.x > 0 ? max.x : min.x, g.y > 0 ? max.y : min.y, g.z > 0 ? max.z : min.z};
}

template <class Kernel>
void measure_pressure_with(const Kernel& kernel, const StepContext& s, double time) {
  Particles& particles = s.particles;
  const PointView at = particles.corrected_position.view();
  ScalarField& result = particles.density_ratio;
  float *sum = particles.mean_pressure.data(), *pressure = result.data();
  const auto per_time = static_cast<float>(1 / time);
  const StepView step = s.view();
  const Kernel of_pressure = kernel;
  s.executor.for_each("measure pressure", particles.count + 1, [=] SPINDRIFT_HD(std::uint32_t i) {
    at.value(i) = i < step.count ? sum[i] : 0;  // the sentinel has none
  });
  s.executor.for_each("measure pressure", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    pressure[i] = per_time * mechanical_pressure(i, step.constants, of_pressure, at,
                                                 step.neighbours, step.boundary);
  });
  particles.mean_pressure.swap(result);
}

}  // namespace

void measure_pressure(const StepContext& step, PressureKernel kernel, double time) {
  const float radius = step.constants.support_radius;
  if (kernel == PressureKernel::spiky)
    measure_pressure_with(SpikyKernel(radius), step, time);
  else
    measure_pressure_with(CubicKernel(radius), step, time);
}

double energy_of(const FluidConstants& constants, const Settings& settings,
                 const glm::vec3& position, const glm::vec3& velocity) {
  const Vec3<float> lowest = lowest_corner(settings);
  const glm::dvec3 fall = glm::dvec3(position) - glm::dvec3(lowest.x, lowest.y, lowest.z);
  const double mass = double{constants.rest_density} * constants.volume;
  return mass * (0.5 * glm::dot(glm::dvec3(velocity), glm::dvec3(velocity)) -
                 glm::dot(fall, glm::dvec3(settings.forces.gravity)));
}

Measured measure(Executor& executor, Particles& particles, Neighbourhood& neighbourhood,
                 const FluidConstants& constants, const Settings& settings, float radius) {
  const Vec3Arrays x = particles.position.view();
  const PointView at = particles.drifted_position.view();
  executor.for_each("measure", particles.count,
                    [=] SPINDRIFT_HD(std::uint32_t i) { at.set(i, x[i]); });
  neighbourhood.update(executor, particles, radius);
  const CubicKernel kernel(constants.support_radius);
  const NeighbourView neighbours = neighbourhood.fluid();
  const BoundaryView solid = neighbourhood.boundary();
  const PointView position = particles.drifted_position.view();
  const Vec3Arrays v = particles.velocity.view();
  const float* pressure = particles.pressure.data();
  float* ratio = particles.density_ratio.data();
  const Vec3<float> down = from_glm(settings.forces.gravity), origin = lowest_corner(settings);
  const FluidConstants c = constants;
  const auto measure_one = [=] SPINDRIFT_HD(std::uint32_t i) {
    ratio[i] = density_ratio(i, c, kernel, position, neighbours, solid);
    const float error = std::max(0.f, ratio[i] - 1.f);
    const double p = pressure[i];
    return Totals{error, dot(v[i], v[i]), -dot(position[i] - origin, down), p * p, error};
  };
  const auto t = executor.reduce<Totals>("measure", particles.count, measure_one);
  const double mass = double{constants.rest_density} * constants.volume;
  const double count = std::max(1u, particles.count);
  return {.mean_compression = t.compression / count,
          .max_compression = t.max_compression,
          .kinetic_energy = 0.5 * mass * t.squared_speed,
          .potential_energy = mass * t.height,
          .rms_pressure = std::sqrt(t.squared_pressure / count)};
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
