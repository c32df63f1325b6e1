// Drag of the air on the liquid's surface and its spray, after Gissler, Band, Peer, Ihmsen and
// Teschner 2017, "Approximate air-fluid interactions for SPH". Air is not simulated: it moves as
// the scene says, and every particle feels ½ ρₐ C A |u| u of its velocity u relative to the
// particle. A particle alone is a drop; one with neighbours offers a square of its spacing, as far
// as none of them is before it.
#pragma once

#include "sim/forces/force.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// What the drag on a drop of one particle's volume depends on besides its speed.
struct DropDrag {
  float radius;             ///< of a ball of that volume, m
  float air_density;        ///< kg/m³
  float air_viscosity;      ///< Pa·s
  float tension;            ///< that keeps drops round, N/m
  float spacing;            ///< m
  float enough_neighbours;  ///< with so many a particle is no drop any more
  float mass;               ///< kg

  /// How far wind flattens a drop, 0 ... 1: the steady state of Taylor's analogy, in which a drop
  /// is a mass on a spring (O'Rourke & Amsden 1987).
  SPINDRIFT_HD float flatness(float speed) const;

  /// Of a ball (Putnam 1961, as Liu, Mather & Reitz 1993 have it), and more where it is flattened.
  SPINDRIFT_HD float coefficient(float speed, float flatness) const;

  /// Coefficient times area of a particle that so many others are near, m², with none before it.
  SPINDRIFT_HD float area(float speed, float neighbours) const;
};

/// None where the scene has no air.
std::unique_ptr<Force> make_drag(const Settings& settings, const FluidConstants& constants);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
