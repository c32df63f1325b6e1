// Estimates the particles, memory and time that a scene needs, without simulating it.
#pragma once

#include <cstddef>

#include "app/scene/scene.hpp"

namespace spindrift::app {

struct Estimate {
  std::size_t particles = 0;           ///< liquid particles at most, those of emitters included
  std::size_t boundary_particles = 0;  ///< rough; one layer on every wall and obstacle
  double bytes = 0.;                   ///< memory, rough
  double seconds = 0.;  ///< wall-clock time of the whole command, within a factor of three
};

/// Estimates the cost of simulating and rendering a scene.
/// @param threads number of threads that share the work
Estimate estimate(const Scene& scene, int threads);

/// The number of liquid particles at the start. It is exact up to about two million, and above that
/// follows from the volumes' sizes, so that it always takes little time and memory.
std::size_t count_particles(const sim::Settings& settings);

/// Whether the volumes have so few particles, fewer than about two million, that filling them takes
/// some tenths of a second at most.
bool is_cheap_to_fill(const sim::Settings& settings);

/// The rough number of particles on the domain's walls and on obstacles that reach into the domain.
double count_boundary_particles(const sim::Settings& settings);

/// The number of particles that emitters bring until a time, s, where nothing is in their way.
double count_emitted(const sim::Settings& settings, double time);

}  // namespace spindrift::app
