#include "sim/particles/particle_exchange.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

constexpr std::string_view phase = "exchange particles";

template <class T>
void gather(Executor& executor, const Array<std::uint32_t>& kept, const T* from, T* to) {
  const std::uint32_t* places = kept.data();
  executor.for_each(phase, static_cast<std::uint32_t>(kept.size()),
                    [=] SPINDRIFT_HD(std::uint32_t k) { to[k] = from[places[k]]; });
}

}  // namespace

void ParticleExchange::append(Executor& executor, Particles& particles,
                              const std::vector<glm::vec3>& positions, const glm::vec3& velocity,
                              const std::vector<std::uint32_t>& ids) {
  const std::uint32_t before = particles.count;
  particles.resize(before + static_cast<std::uint32_t>(positions.size()));
  const auto field = [&](ScalarField& of) {
    return of.empty() ? nullptr : of.resized(particles.count);
  };
  float* compression = field(particles.compression);
  float* mean_pressure = field(particles.mean_pressure);
  put(new_positions_, positions);
  put(new_ids_, ids);
  const Vec3Arrays x = particles.position.view(), v = particles.velocity.view();
  float* pressure = particles.pressure.data();
  std::uint32_t* id = particles.ids.data();
  const glm::vec3* new_positions = new_positions_.data();
  const std::uint32_t* new_ids = new_ids_.data();
  const Vec3<float> new_velocity = from_glm(velocity);
  const auto count = static_cast<std::uint32_t>(positions.size());
  executor.for_each(phase, count, [=] SPINDRIFT_HD(std::uint32_t k) {
    const std::uint32_t i = before + k;
    x.set(i, from_glm(new_positions[k]));
    v.set(i, new_velocity);
    pressure[i] = 0;
    if (compression != nullptr)
      compression[i] = 0;
    if (mean_pressure != nullptr)
      mean_pressure[i] = 0;
    id[i] = new_ids[k];
  });
}

void ParticleExchange::keep(Executor& executor, Particles& particles,
                            const Array<std::uint32_t>& kept) {
  // The density ratios are of the last step, and nobody's any more.
  ScalarField& scratch = particles.density_ratio;
  const auto keep_of = [&](ScalarField& field) {
    if (field.empty())
      return;
    gather(executor, kept, static_cast<const float*>(field.data()), scratch.data());
    field.swap(scratch);
  };
  for (VectorField* field : {&particles.position, &particles.velocity})
    for (int c = 0; c < 3; ++c)
      keep_of(field->component(c));
  for (ScalarField* field : {&particles.pressure, &particles.compression, &particles.mean_pressure})
    keep_of(*field);
  grow(new_ids_, kept.size());
  gather(executor, kept, static_cast<const std::uint32_t*>(particles.ids.data()), new_ids_.data());
  particles.ids.swap(new_ids_);
  const auto count = static_cast<std::uint32_t>(kept.size());
  particles.resize(count);
  for (ScalarField* field : {&particles.compression, &particles.mean_pressure})
    if (!field->empty())
      field->resize(count);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
