#include "sim/run/state.hpp"

#include <algorithm>
#include <cmath>

#include "sim/pressure/pcisph.hpp"
#include "sim/pressure/wcsph.hpp"
#include "sim/start/initial.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

float speed_of_sound_in(const Settings& settings) {
  const SolverSettings& solver = settings.solver;
  return solver.type != SolverType::sph || solver.speed_of_sound > 0
             ? solver.speed_of_sound
             : default_speed_of_sound(settings);
}

/// The longest step in which the solver and all forces are stable, s.
float time_step_limit(const PressureSolver& solver,
                      const std::vector<std::unique_ptr<Force>>& forces) {
  float limit = solver.time_step_limit();
  for (const auto& force : forces)
    limit = std::min(limit, force->time_step_limit());
  return limit;
}

}  // namespace

State::State(const Settings& s, std::size_t initial_count, Stop stop)
    : settings(s),
      constants(constants_of(s.fluid)),
      map(grid_over(s, list_radius())),
      walls(s, map, constants.support_radius, stop),
      neighbourhood(map, walls.boundary()),
      speed_of_sound(speed_of_sound_in(s)),
      solver(make_solver(s.solver)),
      forces(forces_of(s, constants)),
      time_step(s.solver, constants, time_step_limit(*solver, forces)),
      inflow(s, constants, static_cast<std::uint32_t>(initial_count)),
      outflow(s, constants) {
  executor.obey(stop);
  inflow.attach(walls);
}

std::unique_ptr<PressureSolver> State::make_solver(const SolverSettings& s) const {
  if (s.type == SolverType::pcisph)
    return make_pcisph(s, constants);
  return make_wcsph(s, constants, speed_of_sound);
}

float State::acceleration_size() const {
  const Vec3<float> a = acceleration();
  return std::sqrt(dot(a, a));
}

StepContext State::context_of(double duration, int refusals) {
  return {.executor = executor,
          .particles = particles,
          .constants = constants,
          .neighbours = neighbourhood.fluid(),
          .boundary = neighbourhood.boundary(),
          .grid = neighbourhood.grid(),
          .map = &map,
          .contact = walls.contact(),
          .held = inflow.held(particles),
          .duration = duration,
          .refusals = refusals,
          .kick = kick(duration),
          .acceleration = acceleration_size()};
}

std::size_t State::memory_bytes() const {
  std::size_t bytes = bytes_of(particles, neighbourhood, walls, *solver, executor, inflow, outflow);
  for (const auto& force : forces)
    bytes += bytes_of(*force);
  return bytes;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
