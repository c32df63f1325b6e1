// What a scene will cost, without simulating it.
#pragma once

#include <cstddef>

#include "app/scene/scene.hpp"

namespace spindrift::app {

struct Estimate {
  std::size_t particles = 0;  ///< of liquid; where emitters bring more, the most there can be
  std::size_t boundary_particles = 0;  ///< one layer on every wall and obstacle, roughly
  double bytes = 0.;                   ///< memory, roughly
  double seconds = 0.;  ///< wall clock of the whole command, within a factor of three
};

/// @param threads that share the work
Estimate estimate(const Scene& scene, int threads);

/// Particles of liquid at the start: exact up to some millions, from there on from the volumes'
/// sizes. Takes a moment and little memory whatever the sizes are.
std::size_t count_particles(const sim::Settings& settings);

/// Whether those are so few that filling the volumes takes a moment.
bool is_cheap_to_fill(const sim::Settings& settings);

/// Particles on walls and on obstacles that reach into the domain, roughly.
double count_boundary_particles(const sim::Settings& settings);

/// Particles that come out of emitters until a time, s, where nothing is in their way.
double count_emitted(const sim::Settings& settings, double time);

}  // namespace spindrift::app
