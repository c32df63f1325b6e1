// Liquid beside bodies that cut its lattice, brought to rest before the time begins. What is spread
// evenly there (packing.hpp) is so under a pressure that is the same everywhere; under the one that
// a depth of liquid makes it is not, and would set off at some tenths of a metre a second. So it
// takes a number of steps in which it keeps no speed, while all other liquid stays.
#pragma once

#include "sim/core/frame.hpp"
#include "sim/core/settings.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class Creep {
 public:
  static constexpr int steps = 30;

  /// @param initial with particles that are loose @param next_id above the numbers of all particles
  Creep(const InitialParticles& initial, std::uint32_t next_id);

  /// The longest step in which an acceleration, m/s², moves liquid a small part of the spacing, s.
  static double longest_step(double acceleration, float spacing);

  /// Tolerances of the steps: where loose particles meet those that stay, some compression is left
  /// over and above what a step leaves.
  static SolverSettings tightened(SolverSettings settings);

  /// Notes where the particles are and how fast, and stops them.
  void begin(Executor& executor, Particles& particles);
  /// After each step: stops them again, and puts those back that are to stay.
  void end_step(Executor& executor, Particles& particles);
  /// Gives the particles their speed again.
  void end(Executor& executor, Particles& particles);

 private:
  // By the particles' numbers.
  Array<std::uint32_t> is_loose_;    ///< 1, or 0: it stays
  VectorField position_, velocity_;  ///< before the steps, m, m/s
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
