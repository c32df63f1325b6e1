// The time step, and what is measured of the liquid after it.
#pragma once

#include "sim/run/state.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Takes one step at the state's time, which stays what it is: bodies move, particles drift, forces
/// act, pressure corrects. A step that the solver refuses is repeated with a smaller size.
/// @param longest the size to begin with, s
/// @return the size of the step that was taken, s
double take_step(State& state, double longest, FrameStatistics& statistics);

/// Takes steps up to a time (s) exactly, and measures the liquid there.
void advance(State& state, double end, FrameStatistics& statistics);

/// Lets particles come and go, at the end of a step or at the start of a run.
/// @return whether some have come close to others, or a wall has opened
bool exchange_particles(State& state);

/// Moves particles apart where others have come too close to them, without a velocity, and measures
/// them.
void let_in(State& state);

/// Measures the liquid as it is now.
void measure(State& state, FrameStatistics& statistics);

/// Measures particles that are given or have been moved, and lets the solver take over what it
/// finds.
void measure_start(State& state);

/// Sets the sums of pressure over time to zero, of particles and boundary particles.
void forget_mean_pressures(State& state);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
