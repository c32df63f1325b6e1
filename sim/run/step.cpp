#include "sim/run/step.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "sim/pressure/settle.hpp"
#include "sim/step/leapfrog.hpp"
#include "sim/step/measure.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// Whether a time (s) is that which is to be reached, but for rounding.
bool is_reached(double end, double time) {
  return end - time <= 1e-9 * std::max(1.0, std::abs(end));
}

/// The fastest speed that limits a step before `end` (s), m/s: of the particles, or in it of walls
/// or in a nozzle.
double fastest_speed(const State& s, double end) {
  const SolverSettings& solver = s.settings.solver;
  const double longest = std::min(end - s.time, double{solver.max_time_step});
  const double distance = solver.cfl * s.constants.support_radius;
  const double step = s.walls.step_within(distance, s.time, longest);
  const double speed =
      std::max(s.max_speed, s.inflow.speed_within(s.time, s.time + solver.max_time_step));
  return step < longest ? std::max(speed, distance / step) : speed;
}

/// The size of the next step on the way to `end` (s), s.
double next_size(State& s, double end) {
  const double goal = s.inflow.next_begin(s.time, end);
  return s.time_step.next(goal - s.time, fastest_speed(s, goal), s.acceleration_size(),
                          s.mean_pressure);
}

Motion drift(State& s, double duration) {
  const Motion motion =
      drift(s.executor, s.particles, s.walls.contact(), s.inflow.held(s.particles),
            s.kick(duration) * s.acceleration(), static_cast<float>(duration));
  s.inflow.carry(s.executor, s.particles, s.time + duration);
  return motion;
}

void apply_forces(State& s, double duration, int refusals) {
  for (const auto& force : s.forces)
    if (force->apply(s.context_of(duration, refusals)))
      s.find_neighbours();
}

/// The work of moving bodies on the liquid in a step, J: by contacts, and by the forces of their
/// boundary particles.
double work_of_walls(State& s, const StepContext& step, double power_of_contacts) {
  if (!s.walls.any_moves())
    return 0;
  return double{s.constants.rest_density} * s.constants.volume * power_of_contacts +
         wall_work(s.executor, s.constants, s.settings.solver.pressure_kernel, s.particles,
                   step.boundary, step.time_step());
}

/// Moves the particles to where pressure has put them.
void finish(State& s, const StepContext& step, float pressure_factor, const Motion& drifted,
            FrameStatistics& statistics) {
  const Motion motion = integrate(step, pressure_factor);
  s.mean_pressure = std::sqrt(motion.squared_pressure / std::max(1u, s.particles.count));
  s.max_speed = std::sqrt(motion.squared_speed);
  statistics.contacts += motion.contacts + drifted.contacts;
  statistics.wall_work += work_of_walls(s, step, motion.wall_power + drifted.wall_power);
  s.solver->finish(step);
  s.summed_time += step.kick;
}

}  // namespace

double take_step(State& s, double longest, FrameStatistics& statistics) {
  double duration = longest;
  for (int refusals = 0;; ++refusals, ++statistics.rejected_steps) {
    s.inflow.open_walls(s.executor, s.walls, s.time, s.time + duration);
    s.walls.move(s.executor, s.time, s.time + duration);
    const Motion drifted = drift(s, duration);
    s.find_neighbours();
    apply_forces(s, duration, refusals);
    const StepContext step = s.context_of(duration, refusals);
    const StepResult result = s.solver->solve(step);
    statistics.iterations += result.iterations;
    if (result.accepted) {
      finish(s, step, result.pressure_factor, drifted, statistics);
      if (is_reached(s.frame_end, s.time + duration))
        measure_pressure(step, s.settings.solver.pressure_kernel, s.summed_time);
      s.time_step.accepted(duration);
      return duration;
    }
    duration = s.time_step.refused(duration);
  }
}

void advance(State& s, double end, FrameStatistics& statistics) {
  s.frame_end = end;
  if (!is_reached(end, s.time))
    forget_mean_pressures(s);
  while (!is_reached(end, s.time)) {
    const double size = take_step(s, next_size(s, end), statistics);
    s.time += size;
    if (is_reached(end, s.time))
      s.time = end;
    if (exchange_particles(s))
      let_in(s);
    statistics.min_time_step =
        statistics.steps == 0 ? size : std::min(statistics.min_time_step, size);
    statistics.max_time_step = std::max(statistics.max_time_step, size);
    ++statistics.steps;
  }
  s.time = end;
  measure(s, statistics);
  s.solver->take_over(s.context_of(s.time_step.last(), 0));
  statistics.exchange = std::exchange(s.exchange, {});
}

bool exchange_particles(State& s) {
  if (!s.inflow.exists() && !s.outflow.exists())
    return false;
  s.exchange += s.outflow.apply(s.executor, s.particles, s.inflow.held(s.particles));
  s.exchange += s.inflow.advance(s.executor, s.particles, s.walls, s.time, s.time_step.last(),
                                 s.acceleration());
  s.max_speed = largest_speed(s.executor, s.particles);
  return s.inflow.disturbs();
}

void let_in(State& s) {
  FrameStatistics found;
  measure(s, found);
  if (found.max_compression > s.settings.solver.max_compression)
    settle(s.executor, s.particles, s.neighbourhood, s.inflow, s.constants, s.settings.solver,
           s.map, s.walls.contact(), s.list_radius(), Occasion::arrival);
  measure_start(s);
}

void measure(State& s, FrameStatistics& statistics) {
  s.walls.move(s.executor, s.time, s.time);
  const Measured m =
      measure(s.executor, s.particles, s.neighbourhood, s.constants, s.settings, s.list_radius());
  // The same number for a run in one piece and one that goes on from here.
  s.mean_pressure = m.rms_pressure;
  statistics.mean_compression = m.mean_compression;
  statistics.max_compression = m.max_compression;
  statistics.max_speed = s.max_speed;
  statistics.particles = s.particles.count;
  statistics.kinetic_energy = m.kinetic_energy;
  statistics.potential_energy = m.potential_energy;
}

void measure_start(State& s) {
  FrameStatistics unused;
  measure(s, unused);
  s.solver->take_over(s.context_of(s.time_step.last(), 0));
}

void forget_mean_pressures(State& s) {
  s.particles.mean_pressure.resize(s.particles.count);
  s.particles.mean_pressure.fill(0);
  s.walls.boundary().mean_pressures().fill(0);
  s.summed_time = 0;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
