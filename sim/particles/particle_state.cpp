#include "sim/particles/particle_state.hpp"

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
    particles.pressure[i] = frame.constraint_multipliers[i];
    particles.mean_pressure[i] = frame.pressures[i];
    particles.ids[i] = frame.ids[i];
  }
}

ParticleCopies copy_particles(Executor& executor, Particles& particles, float rest_density) {
  constexpr std::string_view phase = "take frame";
  const std::uint32_t n = particles.count;
  const Vec3Arrays x = particles.position.view(), v = particles.velocity.view();
  const float *ratio = particles.density_ratio.data(), *multiplier = particles.pressure.data(),
              *pressure =
                  particles.mean_pressure.empty() ? nullptr : particles.mean_pressure.data();
  const std::uint32_t* ids = particles.ids.data();
  const auto position = [=] SPINDRIFT_HD(std::uint32_t i) { return to_glm(x[i]); };
  const auto velocity = [=] SPINDRIFT_HD(std::uint32_t i) { return to_glm(v[i]); };
  const auto density = [=] SPINDRIFT_HD(std::uint32_t i) { return ratio[i] * rest_density; };
  const auto mean_pressure = [=] SPINDRIFT_HD(std::uint32_t i) {
    return pressure != nullptr ? pressure[i] : 0.f;
  };
  const auto last_multiplier = [=] SPINDRIFT_HD(std::uint32_t i) { return multiplier[i]; };
  const auto id = [=] SPINDRIFT_HD(std::uint32_t i) { return ids[i]; };
  return {.positions = executor.copy<glm::vec3>(phase, n, position),
          .velocities = executor.copy<glm::vec3>(phase, n, velocity),
          .densities = executor.copy<float>(phase, n, density),
          .pressures = executor.copy<float>(phase, n, mean_pressure),
          .constraint_multipliers = executor.copy<float>(phase, n, last_multiplier),
          .ids = executor.copy<std::uint32_t>(phase, n, id)};
}

void ParticleCopies::put_into(Frame& frame) {
  frame.positions = positions.take();
  frame.velocities = velocities.take();
  frame.densities = densities.take();
  frame.pressures = pressures.take();
  frame.constraint_multipliers = constraint_multipliers.take();
  frame.ids = ids.take();
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
