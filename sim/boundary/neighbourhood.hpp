// Keeps the particles sorted by cell and their neighbour lists up to date.
#pragma once

#include "sim/backend/backend.hpp"
#include "sim/boundary/boundary.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class Neighbourhood {
 public:
  Neighbourhood(const GridMap& map, Boundary& boundary) : map_(map), boundary_(boundary) {}

  /// Sorts the particles by the cells of their drifted positions and lists, around those, all fluid
  /// and boundary particles within `radius`. Carries along the state and the drifted positions and
  /// velocities.
  void update(Executor& executor, Particles& particles, float radius);

  CellGridView grid() const { return grid_.view(); }
  NeighbourView fluid() const { return fluid_.view(); }
  BoundaryView boundary() {
    return {.position = boundary_.positions(),
            .solid = boundary_.solids(),
            .wall_viscosity = boundary_.wall_viscosities(),
            .velocity = boundary_.velocities(),
            .pressure = boundary_.pressures().data(),
            .step_pressure = boundary_.step_pressures().data(),
            .compression = boundary_.compressions().data(),
            .mean_pressure = boundary_.mean_pressures().data(),
            .neighbours = boundary_lists_.view(),
            .fluid = wet_lists_.view(),
            .wet = wet_.data(),
            .wet_count = static_cast<std::uint32_t>(wet_.size()),
            .count = boundary_.count()};
  }
  std::size_t memory_bytes() const;

 private:
  void reorder(Executor& executor, Particles& particles);

  GridMap map_;
  Boundary& boundary_;
  CellGrid grid_;
  NeighbourLists fluid_, boundary_lists_;
  NeighbourLists wet_lists_;  ///< of each boundary sample: fluid particles
  Array<std::uint32_t> wet_;  ///< boundary samples with fluid neighbours
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
