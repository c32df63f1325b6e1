#include "sim/boundary/neighbourhood.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// Brings a field of the particles into the grid's new order, by copying it into a spare array and
/// swapping the two.
struct Reordering {
  Executor& executor;
  Particles& particles;
  CellGrid& grid;

  void operator()(ScalarField& field) const {
    permute(field.data(), particles.spare().data());
    field.swap(particles.spare());
  }
  void operator()(VectorField& field) const {
    for (int c = 0; c < 3; ++c)
      (*this)(field.component(c));
  }
  void operator()(PointField& field) const {
    permute(field.view().rows, particles.spare_points().view().rows);
    field.swap(particles.spare_points());
  }
  void operator()(IdField& field) const { grid.permute(field.array()); }

  template <class T>
  void permute(const T* from, T* to) const {
    const std::uint32_t* order = grid.order().data();
    executor.for_each("reorder one field", particles.count,
                      [=] SPINDRIFT_HD(std::uint32_t i) { to[i] = from[order[i]]; });
  }
};

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
  float* held = particles.held.empty() ? nullptr : particles.held.data();
  executor.for_each("sentinel", 1, [=] SPINDRIFT_HD(std::uint32_t) {
    points.set(n, {sentinel_position, sentinel_position, sentinel_position});
    if (held != nullptr)
      held[n] = 0;
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
  const PhaseClock::Scope timed(executor.clock(), "reorder");
  const Reordering reorder{executor, particles, grid_};
  particles.for_each_field([&](const auto& info, auto& field) {
    if (info.lifetime != Lifetime::scratch)
      reorder(field);
  });
}

std::size_t Neighbourhood::memory_bytes() const {
  return bytes_of(grid_, fluid_, boundary_lists_, wet_lists_, wet_);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
