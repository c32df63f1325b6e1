#include "sim/particles/particle_exchange.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

constexpr std::string_view phase = "exchange particles";

/// Sets a field to zero for new particles, which start with nothing but a position, a velocity and
/// an id.
struct Clearing {
  Executor& executor;
  std::uint32_t begin, count;  ///< the range of the new particles

  template <class T>
  void operator()(NumberField<T>& field) const {
    T* values = field.data() + begin;
    executor.for_each(phase, count, [=] SPINDRIFT_HD(std::uint32_t k) { values[k] = 0; });
  }
  void operator()(VectorField&) const {}
  void operator()(PointField&) const {}
};

/// Reduces a field to the values of the particles that are kept.
struct Gathering {
  Executor& executor;
  Particles& particles;
  const Array<std::uint32_t>& kept;
  Array<std::uint32_t>& spare_ids;

  void operator()(ScalarField& field) const {
    gather(field.data(), particles.spare().data());
    field.swap(particles.spare());
  }
  void operator()(VectorField& field) const {
    for (int c = 0; c < 3; ++c)
      (*this)(field.component(c));
  }
  void operator()(IdField& field) const {
    grow(spare_ids, field.array().size());
    gather(field.data(), spare_ids.data());
    field.array().swap(spare_ids);
  }
  void operator()(PointField&) const {}

  template <class T>
  void gather(const T* from, T* to) const {
    const std::uint32_t* places = kept.data();
    executor.for_each(phase, static_cast<std::uint32_t>(kept.size()),
                      [=] SPINDRIFT_HD(std::uint32_t k) { to[k] = from[places[k]]; });
  }
};

}  // namespace

void ParticleExchange::append(Executor& executor, Particles& particles,
                              const std::vector<glm::vec3>& positions, const glm::vec3& velocity,
                              const std::vector<std::uint32_t>& ids) {
  const std::uint32_t before = particles.count;
  const auto count = static_cast<std::uint32_t>(positions.size());
  particles.resize(before + count);
  const Clearing clear{executor, before, count};
  particles.for_each_field([&](const auto& info, auto& field) {
    if (info.lifetime == Lifetime::state)
      clear(field);
  });
  put(new_positions_, positions);
  put(new_ids_, ids);
  const Vec3Arrays x = particles.position.view(), v = particles.velocity.view();
  std::uint32_t* id = particles.ids.data();
  const glm::vec3* new_positions = new_positions_.data();
  const std::uint32_t* new_ids = new_ids_.data();
  const Vec3<float> new_velocity = from_glm(velocity);
  executor.for_each(phase, count, [=] SPINDRIFT_HD(std::uint32_t k) {
    const std::uint32_t i = before + k;
    x.set(i, from_glm(new_positions[k]));
    v.set(i, new_velocity);
    id[i] = new_ids[k];
  });
}

void ParticleExchange::keep(Executor& executor, Particles& particles,
                            const Array<std::uint32_t>& kept) {
  const Gathering gather{executor, particles, kept, new_ids_};
  particles.for_each_field([&](const auto& info, auto& field) {
    if (info.lifetime == Lifetime::state)
      gather(field);
  });
  particles.resize(static_cast<std::uint32_t>(kept.size()));
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
