#include "sim/simulation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>

#include "sim/initial.hpp"
#include "sim/leftover.hpp"
#include "sim/measure.hpp"
#include "sim/neighbourhood.hpp"
#include "sim/pcisph.hpp"
#include "sim/shapes.hpp"
#include "sim/surface_tension.hpp"
#include "sim/time_step.hpp"
#include "sim/viscosity.hpp"
#include "sim/wcsph.hpp"

namespace spindrift::sim {
namespace {

/// Neighbours are listed a little beyond the support radius, since pressure moves particles on from
/// where the lists were made.
constexpr float list_radius_factor = 1.05f;

struct Motion {
  float squared_speed = 0;
  std::int64_t contacts = 0;
  double squared_pressure = 0;
  void join(const Motion& o) {
    squared_speed = std::max(squared_speed, o.squared_speed);
    contacts += o.contacts;
    squared_pressure += o.squared_pressure;
  }
};

}  // namespace

struct Simulation::Impl {
  Settings settings;
  FluidConstants constants;
  Executor executor;
  Particles particles;
  GridMap map;
  Boundary boundary;
  Neighbourhood neighbourhood;
  std::unique_ptr<PressureSolver> solver;
  TimeStepControl time_step;
  double time = 0;
  float max_speed = 0;
  double mean_pressure = 0;  ///< root mean square over the particles, Pa
  std::int64_t drift_contacts = 0;
  std::optional<SurfaceTension> surface_tension;
  Viscosity viscosity;
  Leftover leftover;

  Impl(const Settings& s, const InitialParticles& initial)
      : settings(s),
        constants(constants_of(s.fluid)),
        map(GridMap::over(from_glm(s.domain.min - s.fluid.spacing),
                          from_glm(s.domain.max + s.fluid.spacing),
                          list_radius_factor * constants.support_radius)),
        boundary(s, map, constants.support_radius),
        neighbourhood(map, boundary),
        solver(make_solver(initial)),
        time_step(s.solver, constants,
                  std::min(solver->time_step_limit(), SurfaceTension::time_step_limit(constants))),
        viscosity(constants),
        leftover(s.solver, constants.support_radius) {
    if (constants.surface_tension > 0)
      surface_tension.emplace(constants);
    if (initial.positions.empty())
      throw std::invalid_argument(
          "the scene has no particles: no volume is as wide as fluid.spacing");
    const auto n = static_cast<std::uint32_t>(initial.positions.size());
    particles.resize(n);
    for (std::uint32_t i = 0; i < n; ++i) {
      particles.position.view().set(i, from_glm(initial.positions[i]));
      particles.velocity.view().set(i, from_glm(initial.velocities[i]));
      particles.ids[i] = i;
      max_speed = std::max(max_speed, glm::length(initial.velocities[i]));
    }
  }

  std::unique_ptr<PressureSolver> make_solver(const InitialParticles& initial) const {
    if (settings.solver.type == SolverType::pcisph)
      return make_pcisph(settings.solver, constants);
    const float c = settings.solver.speed_of_sound;
    return make_wcsph(settings.solver, constants,
                      c > 0 ? c : default_speed_of_sound(settings, initial));
  }

  ContactView contact() const {
    return {from_glm(settings.domain.min), from_glm(settings.domain.max), settings.obstacles.data(),
            settings.obstacles.size()};
  }

  bool viscous() const { return constants.viscosity > 0 || constants.wall_viscosity > 0; }
  bool corrects_density() const { return settings.solver.type == SolverType::pcisph; }

  void find_neighbours() {
    neighbourhood.update(executor, particles, list_radius_factor * constants.support_radius);
  }

  StepContext context_of(double dt, int refusals, const float* excess) {
    return {.executor = executor,
            .particles = particles,
            .constants = constants,
            .neighbours = neighbourhood.fluid(),
            .boundary = neighbourhood.boundary(),
            .grid = &neighbourhood.grid(),
            .map = &map,
            .contact = contact(),
            .time_step = static_cast<float>(dt),
            .refusals = refusals,
            .kick = kick(dt),
            .excess = excess,
            .rate = leftover.rate(),
            .overlapping = leftover.overlapping(),
            .densest = leftover.densest()};
  }

  const float* allowed_leftover(double dt, int refusals) {
    if (!corrects_density())
      return nullptr;
    const Vec3<float> a = body_acceleration(settings.forces, time);
    return leftover.allow(executor, particles, neighbourhood.grid(), dt, refusals,
                          std::sqrt(dot(a, a)));
  }

  /// One accepted step of at most dt; returns its length, s.
  double step(double dt, FrameStatistics& statistics) {
    for (int refusals = 0;; ++refusals, dt = time_step.refused(dt), ++statistics.rejected_steps) {
      drift(dt);
      find_neighbours();
      if (surface_tension && surface_tension->apply(context_of(dt, refusals, nullptr)))
        find_neighbours();
      if (viscous() && viscosity.apply(context_of(dt, refusals, nullptr)))
        find_neighbours();
      const StepContext context = context_of(dt, refusals, allowed_leftover(dt, refusals));
      const StepResult result = solver->solve(context);
      statistics.iterations += result.iterations;
      if (!result.accepted)
        continue;
      statistics.contacts += integrate(context, result.pressure_factor);
      break;
    }
    time_step.accepted(dt);
    return dt;
  }

  /// Time between the middle of the last step and the middle of one of length dt, s.
  float kick(double dt) const { return static_cast<float>(0.5 * (time_step.last() + dt)); }

  /// All but what depends on neighbours. Leapfrog: velocities belong to the middle of a step, so
  /// that the kick at its start spans half of the last step and half of this one, and free fall is
  /// exact.
  void drift(double dt) {
    const float step = static_cast<float>(dt);
    const Vec3<float> dv = kick(dt) * body_acceleration(settings.forces, time);
    const Vec3Arrays x = particles.position.view(), v = particles.velocity.view(),
                     drifted_x = particles.drifted_position.view(),
                     drifted_v = particles.drifted_velocity.view();
    const ContactView walls = contact();
    drift_contacts = executor
                         .reduce<Motion>("drift", particles.count,
                                         [=](std::uint32_t i) {
                                           const Vec3<float> velocity = v[i] + dv;
                                           const Vec3<float> free = x[i] + step * velocity;
                                           const Vec3<float> held = walls.resolve(free);
                                           const Vec3<float> push = held - free;
                                           drifted_x.set(i, held);
                                           drifted_v.set(i, velocity + (1 / step) * push);
                                           return Motion{0, dot(push, push) > 0};
                                         })
                         .contacts;
  }

  /// Takes over the corrected positions; returns how many particles were stopped by a surface.
  std::int64_t integrate(const StepContext& s, float pressure_factor) {
    const Vec3Arrays x = particles.position.view(), v = particles.velocity.view(),
                     drifted_x = particles.drifted_position.view(),
                     drifted_v = particles.drifted_velocity.view(),
                     corrected = particles.corrected_position.view(),
                     a = particles.acceleration.view();
    float *pressure = particles.pressure.data(), *new_pressure = particles.step_pressure.data();
    const float dt = s.time_step;
    const Motion motion =
        executor.reduce<Motion>("integrate", particles.count, [=](std::uint32_t i) {
          const Vec3<float> free = drifted_x[i] + (dt * dt) * a[i];
          const Vec3<float> push = corrected[i] - free;
          const Vec3<float> velocity = drifted_v[i] + dt * a[i] + (1 / dt) * push;
          x.set(i, corrected[i]);
          v.set(i, velocity);
          pressure[i] = pressure_factor * new_pressure[i];
          return Motion{dot(velocity, velocity), dot(push, push) > 0,
                        double{pressure[i]} * pressure[i]};
        });
    mean_pressure = std::sqrt(motion.squared_pressure / particles.count);
    const BoundaryView& solid = s.boundary;
    for (std::uint32_t k = 0; k < solid.wet_count; ++k)
      solid.pressure[solid.wet[k]] = pressure_factor * solid.step_pressure[solid.wet[k]];
    max_speed = std::sqrt(motion.squared_speed);
    note_leftover(true);
    return motion.contacts + drift_contacts;
  }

  void note_leftover(bool after_a_step) {
    if (corrects_density())
      leftover.note(executor, particles, after_a_step);
  }

  /// Measures particles as they are given.
  void measure_start() {
    FrameStatistics unused;
    measure(unused);
    note_leftover(false);
  }

  /// The liquid as it is now.
  void measure(FrameStatistics& statistics) {
    const Measured m =
        spindrift::sim::measure(executor, particles, neighbourhood, constants, settings,
                                list_radius_factor * constants.support_radius);
    // The same number for a run in one piece and one that goes on from here.
    mean_pressure = m.rms_pressure;
    statistics.mean_compression = m.mean_compression;
    statistics.max_compression = m.max_compression;
    statistics.max_speed = max_speed;
    statistics.kinetic_energy = m.kinetic_energy;
    statistics.potential_energy = m.potential_energy;
  }

  FrameStatistics advance_to(double end, const std::atomic<bool>* stop) {
    FrameStatistics statistics;
    if (time_step.last() == 0)
      measure_start();
    const double tiny = 1e-9 * std::max(1.0, std::abs(end));
    while (end - time > tiny) {
      if (stop != nullptr && *stop)
        return statistics;
      const Vec3<float> a = body_acceleration(settings.forces, time);
      const double wanted =
          time_step.next(end - time, max_speed, std::sqrt(dot(a, a)), mean_pressure);
      const double dt = step(wanted, statistics);
      time += dt;
      statistics.min_time_step =
          statistics.steps == 0 ? dt : std::min(statistics.min_time_step, dt);
      statistics.max_time_step = std::max(statistics.max_time_step, dt);
      ++statistics.steps;
    }
    time = end;
    measure(statistics);
    note_leftover(false);
    return statistics;
  }
};

Simulation::Simulation(const Settings& settings)
    : impl_(std::make_unique<Impl>(settings, fill_volumes(settings))) {}

Simulation::Simulation(const Settings& settings, const Frame& start)
    : impl_(std::make_unique<Impl>(settings, fill_volumes(settings))) {
  Particles& p = impl_->particles;
  if (start.positions.size() != p.count)
    throw std::invalid_argument(
        fmt::format("cannot go on from a frame of {} particles: the scene has {}",
                    start.positions.size(), p.count));
  float squared_speed = 0;
  for (std::uint32_t i = 0; i < p.count; ++i) {
    p.position.view().set(i, from_glm(start.positions[i]));
    p.velocity.view().set(i, from_glm(start.velocities[i]));
    p.pressure[i] = start.pressures[i];
    p.ids[i] = start.ids[i];
    const Vec3<float> v = from_glm(start.velocities[i]);
    squared_speed = std::max(squared_speed, dot(v, v));
  }
  if (start.boundary_pressures.size() != impl_->boundary.count())
    throw std::invalid_argument("cannot go on from a frame with other walls or obstacles");
  std::copy(start.boundary_pressures.begin(), start.boundary_pressures.end(),
            impl_->boundary.pressures().data());
  impl_->max_speed = std::sqrt(squared_speed);
  impl_->time = start.time;
  impl_->time_step.set_last(start.last_time_step);
  impl_->measure_start();
}

Simulation::~Simulation() = default;

FrameStatistics Simulation::advance_to(double time, const std::atomic<bool>* stop) {
  return impl_->advance_to(time, stop);
}

Frame Simulation::frame() const {
  const Particles& p = impl_->particles;
  Frame frame;
  frame.time = impl_->time;
  frame.last_time_step = impl_->time_step.last();
  frame.ids = p.ids;
  Boundary& boundary = impl_->boundary;
  frame.boundary_pressures.assign(boundary.pressures().data(),
                                  boundary.pressures().data() + boundary.count());
  for (std::uint32_t i = 0; i < p.count; ++i) {
    frame.positions.push_back(p.position.at(i));
    frame.velocities.push_back(p.velocity.at(i));
    frame.densities.push_back(p.density_ratio[i] * impl_->constants.rest_density);
    frame.pressures.push_back(p.pressure[i]);
  }
  return frame;
}

std::size_t Simulation::particle_count() const {
  return impl_->particles.count;
}
std::size_t Simulation::boundary_particle_count() const {
  return impl_->boundary.count();
}

std::size_t Simulation::memory_bytes() const {
  return impl_->particles.memory_bytes() + impl_->neighbourhood.memory_bytes() +
         impl_->boundary.memory_bytes() + impl_->solver->memory_bytes() +
         impl_->viscosity.memory_bytes() +
         (impl_->surface_tension ? impl_->surface_tension->memory_bytes() : 0);
}

std::vector<PhaseTime> Simulation::phase_times() const {
  std::vector<PhaseTime> times;
  for (const auto& e : impl_->executor.clock().entries())
    times.push_back({std::string(e.name), e.seconds, e.calls});
  return times;
}

}  // namespace spindrift::sim
