// Keeps the fluid particles sorted by cell and the neighbour lists of fluid and boundary particles
// up to date.
#pragma once

#include "sim/backend/backend.hpp"
#include "sim/boundary/boundary.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// The cell grid of the fluid particles and the neighbour lists that a step works with.
class Neighbourhood {
 public:
  /// @param map the cells of all places where particles may be
  Neighbourhood(const GridMap& map, Boundary& boundary) : map_(map), boundary_(boundary) {}

  /// Sorts the particles by the cells of their drifted positions and lists, around these positions,
  /// all fluid and boundary particles within `radius`, m. All fields of the particles but scratch
  /// fields are brought into the new order.
  void update(Executor& executor, Particles& particles, float radius);

  CellGridView grid() const { return grid_.view(); }
  /// The fluid neighbours of each fluid particle.
  NeighbourView fluid() const { return fluid_.view(); }
  /// The boundary particles, with the neighbour lists between them and the fluid particles.
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
  NeighbourLists fluid_, boundary_lists_;  ///< neighbours of each fluid particle
  NeighbourLists wet_lists_;               ///< fluid neighbours of each boundary particle
  Array<std::uint32_t> wet_;  ///< indices of the boundary particles with fluid neighbours
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
