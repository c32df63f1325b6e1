// Liquid that starts too dense is let apart before time begins.
#pragma once

#include "sim/boundary/contact.hpp"
#include "sim/boundary/neighbourhood.hpp"
#include "sim/flow/inflow.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Moves particles that start denser than the solver's tolerances allow, as where volumes overlap
/// or reach into a wall, apart until they are not. Positions only: nothing gets a velocity from it,
/// so that the energy of the start is that of the liquid as it can be. Leaves what is not too dense
/// alone, and what a nozzle moves.
/// @param radius within which neighbours are listed, m
/// @return how many sweeps it took; 0 where nothing was too dense
/// @throws std::invalid_argument when it is too dense after hundreds of sweeps, which says how much
/// and where
int settle(Executor& executor, Particles& particles, Neighbourhood& neighbourhood,
           const Inflow& inflow, const FluidConstants& constants, const SolverSettings& settings,
           const GridMap& map, const ContactView& contact, float radius);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
