// The interface of the pressure solvers: the time step that they are given, and their result.
#pragma once

#include "sim/backend/backend.hpp"
#include "sim/boundary/contact.hpp"
#include "sim/particles/formulas.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// The data of a step that formulas and loops need, as plain values that are copied into the loops.
struct StepView {
  FluidConstants constants;
  std::uint32_t count;  ///< number of particles
  NeighbourView neighbours;
  BoundaryView boundary;
  ContactView contact;
  const float* held;    ///< 1 for particles that only a nozzle moves, else 0; null: there are none
  Vec3Arrays position;  ///< positions at the step's start, m
  PointView drifted;    ///< positions at its end but for pressure, m, with the pressure iterate, Pa

  /// Whether particle i has no others near it. The domain's walls stop such a particle at
  /// rest_distance(), where they alone do not make it too dense, and do not throw it back.
  SPINDRIFT_HD bool is_alone(std::uint32_t i) const {
    return neighbours.is_alone(i, count) && !is_held(i);
  }
  /// Distance of the first particles of liquid at rest from a wall, m.
  SPINDRIFT_HD float rest_distance() const { return 0.5f * constants.spacing; }

  /// Where particle i gets from its drifted position by a given move, m, with contact.
  SPINDRIFT_HD Vec3<float> moved(std::uint32_t i, const Vec3<float>& move) const {
    const Vec3<float> from = drifted[i], p = from + move;
    return is_alone(i) ? contact.stop_off_walls(from, p, position[i], rest_distance())
                       : contact.resolve(from, p);
  }

  /// Whether a nozzle moves particle i.
  SPINDRIFT_HD bool is_held(std::uint32_t i) const { return held != nullptr && held[i] > 0; }
};

/// One time step after all but pressure has been applied: the particles have drifted to where they
/// would be without it.
struct StepContext {
  Executor& executor;
  Particles& particles;
  const FluidConstants& constants;
  NeighbourView neighbours;  ///< around the drifted positions
  BoundaryView boundary;
  CellGridView grid;  ///< cells by which the particles are sorted
  const GridMap* map;
  ContactView contact;
  const float* held;  ///< as in StepView
  double duration;    ///< time step size Δt, by which the run's time advances, s
  int refusals;       ///< number of times this step has been tried with a larger Δt
  float kick;  ///< time over which body forces act: half of the last step and half of this one, s
  float acceleration;  ///< magnitude of the body acceleration, such as gravity, m/s²

  /// Δt in the precision of the particles' loops, s.
  float time_step() const { return static_cast<float>(duration); }

  StepView view() const {
    return {.constants = constants,
            .count = particles.count,
            .neighbours = neighbours,
            .boundary = boundary,
            .contact = contact,
            .held = held,
            .position = particles.position.view(),
            .drifted = particles.drifted_position.view()};
  }
};

/// The result of a pressure solve.
struct StepResult {
  bool accepted = true;  ///< false: the step must be repeated with a smaller Δt
  int iterations = 0;
  float pressure_factor = 1;  ///< ratio of the pressure that is kept and reported to the iterate
};

/// A method to find the pressures of a time step.
class PressureSolver {
 public:
  virtual ~PressureSolver() = default;
  /// Finds the pressures, and leaves in Particles the acceleration by pressure, the pressure
  /// iterate beside the drifted positions, and
  ///   corrected position = contact(drifted position + Δt² acceleration).
  /// A particle that is held gets its drifted position and no acceleration.
  virtual StepResult solve(const StepContext& step) = 0;
  /// Ends an accepted step, when the positions are the corrected ones. The solver may move these,
  /// but changes no velocities, and notes what it must know in the next step.
  virtual void finish(const StepContext&) {}
  /// Notes what the solver must know in the next step, from particles that are given or have been
  /// measured: their density ratios are those at their drifted positions.
  virtual void take_over(const StepContext&) {}
  /// Largest time step size at which the solver is stable, s.
  virtual float time_step_limit() const = 0;
  /// Memory of the fields that the solver keeps, bytes.
  virtual std::size_t memory_bytes() const { return 0; }
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
