#include "sim/boundary/neighbourhood.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

float* elements(ScalarField& field) {
  return field.data();
}
PointRow* elements(PointField& field) {
  return field.view().rows;
}

/// Brings a field into a new order, by way of another.
template <class Field>
void permute(Executor& executor, const std::uint32_t* order, std::uint32_t n, Field& field,
             Field& scratch) {
  const auto* from = elements(field);
  auto* to = elements(scratch);
  executor.for_each("reorder one field", n,
                    [=] SPINDRIFT_HD(std::uint32_t i) { to[i] = from[order[i]]; });
  field.swap(scratch);
}

}  // namespace

void Neighbourhood::update(Executor& executor, Particles& particles, float radius) {
  const std::uint32_t n = particles.count;
  {
    const PhaseClock::Scope timed(executor.clock(), "sort");
    grid_.sort(map_, particles.drifted_position.view(), n);
  }
  reorder(executor, particles);

  const PhaseClock::Scope timed(executor.clock(), "neighbour lists");
  const PointView points = particles.drifted_position.view();
  executor.for_each("sentinel", 1, [=] SPINDRIFT_HD(std::uint32_t) {
    points.set(n, {sentinel_position, sentinel_position, sentinel_position});
  });
  fluid_.build(map_, grid_, points, n, grid_, points, n, radius);
  boundary_lists_.build(map_, grid_, points, n, boundary_.grid(), boundary_.positions(),
                        boundary_.count(), radius);
  wet_lists_.build(map_, boundary_.grid(), boundary_.positions(), boundary_.count(), grid_, points,
                   n, radius);
  const NeighbourView around = wet_lists_.view();
  float *pressure = boundary_.pressures().data(),
        *step_pressure = boundary_.step_pressures().data(),
        *compression = boundary_.compressions().data();
  executor.for_each("wet samples", boundary_.count(), [=] SPINDRIFT_HD(std::uint32_t b) {
    if (around.empty(b))
      pressure[b] = step_pressure[b] = compression[b] = 0;
  });
  executor.select("wet samples", boundary_.count(), wet_,
                  [=] SPINDRIFT_HD(std::uint32_t b) { return !around.empty(b); });
}

void Neighbourhood::reorder(Executor& executor, Particles& particles) {
  const std::uint32_t n = particles.count;
  const std::uint32_t* order = grid_.order().data();
  const PhaseClock::Scope timed(executor.clock(), "reorder");
  // Density ratios and corrected positions are of the last step, and nobody's any more.
  ScalarField& scratch = particles.density_ratio;
  for (PointField* field : {&particles.drifted_position, &particles.drifted_velocity})
    permute(executor, order, n, *field, particles.corrected_position);
  for (VectorField* field : {&particles.position, &particles.velocity})
    for (int c = 0; c < 3; ++c)
      permute(executor, order, n, field->component(c), scratch);
  permute(executor, order, n, particles.pressure, scratch);
  for (ScalarField* field : {&particles.compression, &particles.mean_pressure})
    if (!field->empty())
      permute(executor, order, n, *field, scratch);
  grid_.permute(particles.ids);
}

std::size_t Neighbourhood::memory_bytes() const {
  return grid_.memory_bytes() + fluid_.memory_bytes() + boundary_lists_.memory_bytes() +
         wet_lists_.memory_bytes() + wet_.capacity() * sizeof(std::uint32_t);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
