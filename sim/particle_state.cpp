#include "sim/particle_state.hpp"

#include <cmath>

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

void set_particles(Executor& executor, Particles& particles, const InitialParticles& initial) {
  const auto n = static_cast<std::uint32_t>(initial.positions.size());
  particles.resize(n);
  executor.wait();
  for (std::uint32_t i = 0; i < n; ++i) {
    particles.position.view().set(i, from_glm(initial.positions[i]));
    particles.velocity.view().set(i, from_glm(initial.velocities[i]));
    particles.ids[i] = i;
  }
}

void set_particles(Executor& executor, Particles& particles, const Frame& frame) {
  const auto n = static_cast<std::uint32_t>(frame.positions.size());
  particles.resize(n);
  particles.mean_pressure.resize(n);
  executor.wait();
  for (std::uint32_t i = 0; i < n; ++i) {
    particles.position.view().set(i, from_glm(frame.positions[i]));
    particles.velocity.view().set(i, from_glm(frame.velocities[i]));
    particles.pressure[i] = frame.multipliers[i];
    particles.mean_pressure[i] = frame.pressures[i];
    particles.ids[i] = frame.ids[i];
  }
}

void put_particles(const Particles& particles, float rest_density, Frame& frame) {
  const std::uint32_t n = particles.count;
  frame.ids.assign(particles.ids.begin(), particles.ids.end());
  frame.positions.reserve(n);
  frame.velocities.reserve(n);
  frame.densities.reserve(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    frame.positions.push_back(particles.position.at(i));
    frame.velocities.push_back(particles.velocity.at(i));
    frame.densities.push_back(particles.density_ratio[i] * rest_density);
  }
  frame.multipliers.assign(particles.pressure.data(), particles.pressure.data() + n);
  const float* pressure = particles.mean_pressure.data();
  if (particles.mean_pressure.empty())
    frame.pressures.assign(n, 0.f);
  else
    frame.pressures.assign(pressure, pressure + n);
}

float largest_speed(Executor& executor, Particles& particles) {
  const Vec3Arrays v = particles.velocity.view();
  return std::sqrt(
      executor
          .reduce<Largest>("largest speed", particles.count,
                           [=] SPINDRIFT_HD(std::uint32_t i) { return Largest{dot(v[i], v[i])}; })
          .value);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
