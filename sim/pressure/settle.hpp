// Moves liquid apart that has been put somewhere too densely: before time begins, and where a
// nozzle opens into other liquid.
#pragma once

#include "sim/boundary/contact.hpp"
#include "sim/boundary/neighbourhood.hpp"
#include "sim/flow/inflow.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// When particles may be too dense without anything having pressed on them.
enum class Occasion {
  /// Time has not begun: the liquid has to be within both tolerances, but for what nozzles hold.
  start,
  /// A nozzle has opened into liquid: no particle may be denser than the largest compression that
  /// is
  /// allowed, and what twenty sweeps leave is left to the steps.
  arrival,
};

/// Moves particles apart until none is denser than the solver's tolerances allow, as where volumes
/// overlap or reach into a wall. It changes positions only and gives no velocities, so that the
/// energy of the start is that of the liquid as it can be. Liquid that is not too dense, and
/// particles in a nozzle, stay where they are.
/// @param radius within which neighbours are listed, m
/// @return the number of sweeps it took; 0 where nothing was too dense
/// @throws std::invalid_argument when the liquid of a start is still too dense after hundreds of
/// sweeps; the message says by how much and where
int settle(Executor& executor, Particles& particles, Neighbourhood& neighbourhood,
           const Inflow& inflow, const FluidConstants& constants, const SolverSettings& settings,
           const GridMap& map, const ContactView& contact, float radius, Occasion occasion);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
