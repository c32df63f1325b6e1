// Drag of the air on the liquid's surface and its spray, after Gissler, Band, Peer, Ihmsen and
// Teschner 2017, "Approximate air-fluid interactions for SPH". Air is not simulated: it moves as
// the scene says, and every particle feels the force ½ ρₐ C A |u| u of the air's velocity u
// relative to it. A particle alone is a drop; one with neighbours offers the square of its spacing
// to the air, as far as no neighbour stands upwind of it.
#pragma once

#include "sim/forces/force.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Drag on a drop of one particle's volume. Speeds are relative to the air, m/s.
struct DropDrag {
  float radius;             ///< radius of a ball of the particle's volume, m
  float air_density;        ///< kg/m³
  float air_viscosity;      ///< Pa·s
  float tension;            ///< surface tension that keeps drops round, N/m
  float spacing;            ///< m
  float enough_neighbours;  ///< number of neighbours from which on a particle is no drop
  float mass;               ///< mass of the particle, kg

  /// How far the air flattens a drop, 0 ... 1: the steady state of Taylor's analogy, in which a
  /// drop is a mass on a spring (O'Rourke & Amsden 1987).
  SPINDRIFT_HD float flatness(float speed) const;

  /// Drag coefficient: that of a ball (Putnam 1961, as Liu, Mather & Reitz 1993 have it), and more
  /// where the drop is flattened.
  SPINDRIFT_HD float coefficient(float speed, float flatness) const;

  /// Drag coefficient times area of a particle with the given number of neighbours, none of them
  /// upwind of it, m².
  SPINDRIFT_HD float area(float speed, float neighbours) const;
};

/// The drag of a scene's air; null where it has none.
std::unique_ptr<Force> make_drag(const Settings& settings, const FluidConstants& constants);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
