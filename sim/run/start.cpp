#include "sim/run/start.hpp"

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "sim/pressure/creep.hpp"
#include "sim/pressure/settle.hpp"
#include "sim/run/step.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

void check_frame(const State& s, const Frame& frame, std::size_t initial_count) {
  const std::size_t n = frame.positions.size();
  if (n != initial_count && !s.inflow.exists() && !s.outflow.exists())
    throw std::invalid_argument("cannot go on from a frame of " + std::to_string(n) +
                                " particles: the scene has " + std::to_string(initial_count));
  const std::uint32_t end = s.inflow.next_id(frame.time);
  if (std::any_of(frame.ids.begin(), frame.ids.end(), [&](auto id) { return id >= end; }))
    throw std::invalid_argument("cannot go on from a frame with a particle of a number above " +
                                std::to_string(end) + ": the scene has none yet");
}

/// Takes steps at no time, in which only liquid moves that is not at rest beside bodies.
void creep_to_rest(State& s, const std::vector<std::uint32_t>& loose) {
  const double acceleration = s.acceleration_size();
  if (loose.empty() || !(acceleration > 0))
    return;
  const TimeStepControl before = s.time_step;
  const double duration = std::min(s.time_step.next(1, 0, acceleration, s.mean_pressure),
                                   Creep::longest_step(acceleration, s.constants.spacing));
  s.frame_end = std::numeric_limits<double>::max();
  forget_mean_pressures(s);
  std::unique_ptr<PressureSolver> usual = std::move(s.solver);
  s.solver = s.make_solver(Creep::tightened(s.settings.solver));
  s.solver->take_over(s.context_of(duration, 0));
  Creep creep(loose, s.inflow.next_id(0));
  creep.begin(s.executor, s.particles);
  FrameStatistics unused;
  for (int k = 0; k < Creep::steps; ++k) {
    take_step(s, duration, unused);
    creep.end_step(s.executor, s.particles);
  }
  creep.end(s.executor, s.particles);
  s.solver = std::move(usual);
  forget_mean_pressures(s);
  s.time_step = before;
  s.max_speed = largest_speed(s.executor, s.particles);
  measure_start(s);
}

}  // namespace

void begin(State& s, const InitialParticles& initial) {
  if (initial.positions.empty() && !s.inflow.exists())
    throw std::invalid_argument(
        "the scene has no particles: no volume is as wide as fluid.spacing, and there is no "
        "emitter");
  s.executor.check_room(initial.positions.size(), s.constants.spacing);
  set_particles(s.executor, s.particles, initial);
  s.max_speed = largest_speed(s.executor, s.particles);
  s.walls.move(s.executor, 0, 0);
  if (exchange_particles(s))
    measure_start(s);
}

void go_on_from(State& s, const Frame& frame, std::size_t initial_count) {
  check_frame(s, frame, initial_count);
  s.executor.check_room(frame.positions.size(), s.constants.spacing);
  set_particles(s.executor, s.particles, frame);
  s.max_speed = largest_speed(s.executor, s.particles);
  s.walls.move(s.executor, frame.time, frame.time);
  s.executor.wait();
  s.walls.set_pressures(frame.boundary_pressures);
  s.time = frame.time;
  s.time_step.resume(frame.last_time_step, frame.allowed_time_step);
  s.inflow.resume(s.executor, s.particles, s.walls, frame.time);
  measure_start(s);
}

void come_to_rest(State& s, const std::vector<std::uint32_t>& loose) {
  settle(s.executor, s.particles, s.neighbourhood, s.inflow, s.constants, s.settings.solver, s.map,
         s.walls.contact(), s.list_radius(), Occasion::start);
  measure_start(s);
  creep_to_rest(s, loose);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
