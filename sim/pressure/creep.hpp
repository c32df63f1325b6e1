// Brings liquid beside bodies that cut its lattice to rest before the time begins. Particles that
// are spread evenly there (packing.hpp) are at rest under a pressure that is the same everywhere;
// under hydrostatic pressure they are not, and would set off at some tenths of a metre a second. So
// they take a number of steps in which they keep no velocity, while all other particles stay.
#pragma once

#include <vector>

#include "sim/core/settings.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Brings the loose particles of a start to rest in a number of time steps, which the caller takes
/// between begin() and end(), with end_step() after each.
class Creep {
 public:
  static constexpr int steps = 30;  ///< number of steps to take

  /// @param loose the ids of the loose particles
  /// @param next_id a number above the ids of all particles
  Creep(const std::vector<std::uint32_t>& loose, std::uint32_t next_id);

  /// The largest time step size, s, in which an acceleration, m/s², moves liquid no more than a
  /// small part of the spacing, m.
  static double longest_step(double acceleration, float spacing);

  /// Settings with a smaller mean compression, for the solver of these steps: where loose particles
  /// meet those that stay, some compression is left over and above what a step leaves.
  static SolverSettings tightened(SolverSettings settings);

  /// Notes the positions and velocities of all particles, and stops them.
  void begin(Executor& executor, Particles& particles);
  /// Stops all particles again after a step, and puts those that are not loose back.
  void end_step(Executor& executor, Particles& particles);
  /// Gives the particles the velocities again that they had at begin().
  void end(Executor& executor, Particles& particles);

 private:
  // One value per particle, by its id.
  Array<std::uint32_t> is_loose_;    ///< 1 for loose particles, 0 for those that stay
  VectorField position_, velocity_;  ///< values before the steps, m and m/s
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
