// The liquid before time begins.
#pragma once

#include "sim/core/frame.hpp"
#include "sim/run/state.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Puts the particles of a start into a state of time 0.
/// @throws std::invalid_argument where there are none and none will come, std::runtime_error where
/// there is no memory for them
void begin(State& state, const InitialParticles& initial);

/// Puts those of a frame into a state, with all that a run needs to go on from it.
/// @throws std::invalid_argument for a frame that is not one of these settings'
void go_on_from(State& state, const Frame& frame, std::size_t initial_count);

/// Brings the liquid to rest: moves particles apart that are too dense, and lets those that bodies
/// have moved off their lattice creep to where they stay.
/// @param loose the numbers of the latter
void come_to_rest(State& state, const std::vector<std::uint32_t>& loose);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
