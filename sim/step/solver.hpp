// What a pressure solver is given and what it answers.
#pragma once

#include "sim/backend/backend.hpp"
#include "sim/boundary/contact.hpp"
#include "sim/particles/formulas.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// What formulas and loops of a step look at, as plain values that loops carry with them.
struct StepView {
  FluidConstants constants;
  std::uint32_t count;  ///< particles
  NeighbourView neighbours;
  BoundaryView boundary;
  ContactView contact;
  const float* held;    ///< 1: a nozzle moves the particle, and nothing else; null: none
  Vec3Arrays position;  ///< at the step's start, m
  PointView drifted;    ///< where particles are about to be, but for pressure, m

  /// A particle with no others near it: the domain's walls stop it as far off as they are from
  /// liquid at rest, where they alone do not make it too dense, and do not throw it back.
  SPINDRIFT_HD bool alone(std::uint32_t i) const {
    return neighbours.alone(i, count) && !is_held(i);
  }
  SPINDRIFT_HD float rest_distance() const { return 0.5f * constants.spacing; }  ///< m

  /// Where a drifted particle gets by a given move, m.
  SPINDRIFT_HD Vec3<float> moved(std::uint32_t i, const Vec3<float>& move) const {
    const Vec3<float> from = drifted[i], p = from + move;
    return alone(i) ? contact.stop_off_walls(from, p, position[i], rest_distance())
                    : contact.resolve(from, p);
  }

  SPINDRIFT_HD bool is_held(std::uint32_t i) const { return held != nullptr && held[i] > 0; }
};

/// One time step after all but pressure has been applied: particles have drifted to where they
/// would be.
struct StepContext {
  Executor& executor;
  Particles& particles;
  const FluidConstants& constants;
  NeighbourView neighbours;  ///< around the drifted positions
  BoundaryView boundary;
  CellGridView grid;  ///< the cells that the particles are sorted by
  const GridMap* map;
  ContactView contact;
  const float* held;  ///< as in StepView
  float time_step;    ///< Δt, s
  double duration;    ///< the same with all its digits, as time is summed up, s
  int refusals;       ///< how often this step has been tried with a larger Δt
  float kick;  ///< time over which body forces act in it: half of the last step and half of this, s
  float acceleration;  ///< of the body, by gravity and the like, m/s²

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

struct StepResult {
  bool accepted = true;  ///< false: repeat the step with a smaller Δt
  int iterations = 0;
  float pressure_factor = 1;  ///< from the iterate to the pressure that is kept and reported
};

/// Leaves `acceleration` (by pressure), the pressure (beside the drifted positions) and
/// `corrected_position` such that
///   corrected position = contact(drifted position + Δt² acceleration),
/// and, of a particle that is held, the drifted position, with no acceleration.
class PressureSolver {
 public:
  virtual ~PressureSolver() = default;
  virtual StepResult solve(const StepContext& step) = 0;
  /// After an accepted step, when positions are the corrected ones: the solver may move them, and
  /// them alone, and notes what it is to know in the next step.
  virtual void finish(const StepContext&) {}
  /// Notes the same of particles that are given, or have been measured: their density ratios are
  /// those at their drifted positions.
  virtual void take_over(const StepContext&) {}
  /// Largest stable time step of the solver itself, s.
  virtual float time_step_limit() const = 0;
  /// Of the fields that the solver keeps.
  virtual std::size_t memory_bytes() const { return 0; }
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
