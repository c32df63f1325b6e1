#include "sim/particle_exchange.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

void append_particles(Particles& particles, std::span<const glm::vec3> positions,
                      const glm::vec3& velocity, std::span<const std::uint32_t> ids) {
  const std::uint32_t before = particles.count;
  particles.resize(before + static_cast<std::uint32_t>(positions.size()));
  for (ScalarField* field : {&particles.compression, &particles.mean_pressure})
    if (!field->empty())
      field->resize(particles.count);
  for (std::size_t k = 0; k < positions.size(); ++k) {
    const auto i = before + static_cast<std::uint32_t>(k);
    particles.position.view().set(i, from_glm(positions[k]));
    particles.velocity.view().set(i, from_glm(velocity));
    particles.pressure[i] = 0;
    for (ScalarField* field : {&particles.compression, &particles.mean_pressure})
      if (!field->empty())
        (*field)[i] = 0;
    particles.ids[i] = ids[k];
  }
}

void remove_particles(Particles& particles, std::span<const std::uint8_t> gone) {
  const Vec3Arrays x = particles.position.view(), v = particles.velocity.view();
  std::uint32_t kept = 0;
  for (std::uint32_t i = 0; i < particles.count; ++i) {
    if (gone[i] != 0)
      continue;
    x.set(kept, x[i]);
    v.set(kept, v[i]);
    particles.pressure[kept] = particles.pressure[i];
    for (ScalarField* field : {&particles.compression, &particles.mean_pressure})
      if (!field->empty())
        (*field)[kept] = (*field)[i];
    particles.ids[kept] = particles.ids[i];
    ++kept;
  }
  particles.resize(kept);
  for (ScalarField* field : {&particles.compression, &particles.mean_pressure})
    if (!field->empty())
      field->resize(kept);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
