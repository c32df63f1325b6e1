// A run at one moment, on one backend: the liquid, what surrounds it, what acts on it, and where in
// time it is. The steps (step.hpp) and the start (start.hpp) change it.
#pragma once

#include <memory>
#include <vector>

#include "sim/boundary/neighbourhood.hpp"
#include "sim/boundary/walls.hpp"
#include "sim/flow/inflow.hpp"
#include "sim/flow/outflow.hpp"
#include "sim/forces/force.hpp"
#include "sim/particles/particle_state.hpp"
#include "sim/step/solver.hpp"
#include "sim/step/time_step.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

struct State {
  /// Samples the walls and chooses solver and forces; there are no particles yet.
  /// @param settings      with the spacing of the particles: as_filled()
  /// @param initial_count how many particles there are at the start
  /// @throws Stopped
  State(const Settings& settings, std::size_t initial_count, Stop stop);

  Settings settings;
  FluidConstants constants;
  Executor executor;
  Particles particles;
  GridMap map;  ///< the cells of all places where particles may be
  Walls walls;
  Neighbourhood neighbourhood;
  float speed_of_sound;  ///< of basic SPH, m/s; 0 with another solver
  std::unique_ptr<PressureSolver> solver;
  std::vector<std::unique_ptr<Force>> forces;
  TimeStepControl time_step;
  Inflow inflow;
  Outflow outflow;

  double time = 0;           ///< s
  double frame_end = 0;      ///< time of the next frame, s
  double summed_time = 0;    ///< the time that Particles::mean_pressure sums over, s
  float max_speed = 0;       ///< of the fastest particle, m/s
  double mean_pressure = 0;  ///< root mean square over the particles, Pa
  Exchange exchange;         ///< what has come and gone since the last frame

  /// A solver of the scene's kind with the given settings.
  std::unique_ptr<PressureSolver> make_solver(const SolverSettings& settings) const;

  /// The radius within which neighbours are listed, m: a little beyond the support radius, since
  /// pressure moves particles on from where the lists were made.
  float list_radius() const { return 1.05f * constants.support_radius; }

  /// Gravity and the keyframed acceleration, now, m/s².
  Vec3<float> acceleration() const { return body_acceleration(settings.forces, time); }
  /// Its magnitude, m/s².
  float acceleration_size() const;

  /// Sorts the particles and lists the neighbours around their drifted positions.
  void find_neighbours() { neighbourhood.update(executor, particles, list_radius()); }

  /// The time between the middle of the last step and the middle of one of a given duration, s.
  float kick(double duration) const {
    return static_cast<float>(0.5 * (time_step.last() + duration));
  }

  /// What forces and solver see of a step of a given duration (s), tried after so many refusals.
  StepContext context_of(double duration, int refusals);

  /// All memory that the run holds, bytes.
  std::size_t memory_bytes() const;
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
