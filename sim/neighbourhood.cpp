#include "sim/neighbourhood.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

void Neighbourhood::update(Executor& executor, Particles& particles, float radius) {
  const std::uint32_t n = particles.count;
  {
    const PhaseClock::Scope timed(executor.clock(), "sort");
    grid_.sort(map_, particles.drifted_position.view(), n);
  }
  reorder(executor, particles);

  const PhaseClock::Scope timed(executor.clock(), "neighbour lists");
  const Vec3Arrays points = particles.drifted_position.view();
  points.set(n, {sentinel_position, sentinel_position, sentinel_position});
  fluid_.build(map_, grid_, points, n, grid_, points, n, radius);
  boundary_lists_.build(map_, grid_, points, n, boundary_.grid(), boundary_.positions(),
                        boundary_.count(), radius);
  wet_lists_.build(map_, boundary_.grid(), boundary_.positions(), boundary_.count(), grid_, points,
                   n, radius);
  wet_.clear();
  for (std::uint32_t b = 0; b < boundary_.count(); ++b) {
    if (!wet_lists_.view().empty(b))
      wet_.push_back(b);
    else
      boundary_.pressures()[b] = boundary_.step_pressures()[b] = 0;
  }
}

void Neighbourhood::reorder(Executor& executor, Particles& particles) {
  const std::uint32_t n = particles.count;
  const std::uint32_t* order = grid_.order().data();
  const PhaseClock::Scope timed(executor.clock(), "reorder");
  // The density ratios are of the last step, and nobody's any more.
  ScalarField& scratch = particles.density_ratio;
  const auto permute = [&](ScalarField& field) {
    const float* from = field.data();
    float* to = scratch.data();
    executor.for_each("reorder one field", n, [=](std::uint32_t i) { to[i] = from[order[i]]; });
    field.swap(scratch);
  };
  for (VectorField* field : {&particles.position, &particles.velocity, &particles.drifted_position,
                             &particles.drifted_velocity})
    for (int c = 0; c < 3; ++c)
      permute(field->component(c));
  permute(particles.pressure);
  if (!particles.compression.empty())
    permute(particles.compression);
  grid_.permute(particles.ids);
}

std::size_t Neighbourhood::memory_bytes() const {
  return grid_.memory_bytes() + fluid_.memory_bytes() + boundary_lists_.memory_bytes() +
         wet_lists_.memory_bytes() + wet_.capacity() * sizeof(std::uint32_t);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
