#include "sim/simulation.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "sim/inflow.hpp"
#include "sim/initial.hpp"
#include "sim/leftover.hpp"
#include "sim/measure.hpp"
#include "sim/neighbourhood.hpp"
#include "sim/outflow.hpp"
#include "sim/particle_state.hpp"
#include "sim/pcisph.hpp"
#include "sim/settle.hpp"
#include "sim/surface_tension.hpp"
#include "sim/time_step.hpp"
#include "sim/viscosity.hpp"
#include "sim/walls.hpp"
#include "sim/wcsph.hpp"

namespace spindrift::sim {
namespace {

/// Neighbours are listed a little beyond the support radius, since pressure moves particles on from
/// where the lists were made.
constexpr float list_radius_factor = 1.05f;

struct Moved {
  float squared_speed = 0;
  std::int64_t contacts = 0;
  double squared_pressure = 0;
  double wall_impulse = 0;  ///< Σ of what contacts change velocities by, times the walls', m²/s²
  void join(const Moved& o) {
    squared_speed = std::max(squared_speed, o.squared_speed);
    contacts += o.contacts;
    squared_pressure += o.squared_pressure;
    wall_impulse += o.wall_impulse;
  }
};

}  // namespace

struct Simulation::Impl {
  Settings settings;
  FluidConstants constants;
  Executor executor;
  Particles particles;
  GridMap map;
  Walls walls;
  Neighbourhood neighbourhood;
  std::unique_ptr<PressureSolver> solver;
  TimeStepControl time_step;
  double time = 0;
  double frame_end = 0;    ///< s
  double summed_time = 0;  ///< over which Particles::mean_pressure sums, s
  float max_speed = 0;
  double mean_pressure = 0;  ///< root mean square over the particles, Pa
  std::int64_t drift_contacts = 0;
  double drift_impulse = 0;  ///< as Moved::wall_impulse
  std::optional<SurfaceTension> surface_tension;
  Viscosity viscosity;
  Leftover leftover;
  Inflow inflow;
  Outflow outflow;
  Exchange exchange;  ///< since the last frame

  Impl(const Settings& s, const InitialParticles& initial)
      : settings(s),
        constants(constants_of(s.fluid)),
        map(grid_over(s, list_radius_factor * constants.support_radius)),
        walls(s, map, constants.support_radius),
        neighbourhood(map, walls.boundary()),
        solver(make_solver(initial)),
        time_step(s.solver, constants,
                  std::min(solver->time_step_limit(), SurfaceTension::time_step_limit(constants))),
        viscosity(constants, largest_wall_viscosity(s)),
        leftover(s.solver, constants.support_radius),
        inflow(s, constants, static_cast<std::uint32_t>(initial.positions.size())),
        outflow(s, constants) {
    if (constants.surface_tension > 0)
      surface_tension.emplace(constants);
    if (initial.positions.empty() && !inflow.exists())
      throw std::invalid_argument(
          "the scene has no particles: no volume is as wide as fluid.spacing, and there is no "
          "emitter");
    set_particles(particles, initial);
    max_speed = largest_speed(executor, particles);
    inflow.attach(walls);
    walls.move(executor, 0, 0);
  }

  std::unique_ptr<PressureSolver> make_solver(const InitialParticles& initial) const {
    if (settings.solver.type == SolverType::pcisph)
      return make_pcisph(settings.solver, constants);
    const float c = settings.solver.speed_of_sound;
    return make_wcsph(settings.solver, constants,
                      c > 0 ? c : default_speed_of_sound(settings, initial));
  }

  /// @throws std::invalid_argument for a frame that is not one of these settings'
  void check_start(const Frame& start) const {
    const std::size_t n = start.positions.size();
    if (n != particles.count && !inflow.exists() && !outflow.exists())
      throw std::invalid_argument(fmt::format(
          "cannot go on from a frame of {} particles: the scene has {}", n, particles.count));
    const std::uint32_t end = inflow.next_id(start.time);
    if (std::any_of(start.ids.begin(), start.ids.end(), [&](auto id) { return id >= end; }))
      throw std::invalid_argument(fmt::format(
          "cannot go on from a frame with a particle of a number above {}: the scene has none yet",
          end));
  }

  /// The fastest speed that limits the next step, m/s: of the particles, or in it of walls or in a
  /// nozzle.
  double fastest(double end) const {
    const double longest = std::min(end - time, double{settings.solver.max_time_step});
    const double distance = settings.solver.cfl * constants.support_radius;
    const double step = walls.step_within(distance, time, longest);
    const double speed =
        std::max(max_speed, inflow.speed_within(time, time + settings.solver.max_time_step));
    return step < longest ? std::max(speed, distance / step) : speed;
  }

  bool viscous() const { return constants.viscosity > 0 || largest_wall_viscosity(settings) > 0; }
  bool corrects_density() const { return settings.solver.type == SolverType::pcisph; }

  void find_neighbours() {
    neighbourhood.update(executor, particles, list_radius_factor * constants.support_radius);
    inflow.mark(particles);
  }

  StepContext context_of(double dt, int refusals, const float* excess) {
    return {.executor = executor,
            .particles = particles,
            .constants = constants,
            .neighbours = neighbourhood.fluid(),
            .boundary = neighbourhood.boundary(),
            .grid = &neighbourhood.grid(),
            .map = &map,
            .contact = walls.contact(),
            .held = inflow.held(),
            .time_step = static_cast<float>(dt),
            .refusals = refusals,
            .kick = kick(dt),
            .excess = excess,
            .rate = leftover.rate(),
            .kept = leftover.kept(),
            .leftover = leftover.total()};
  }

  const float* allowed_leftover(double dt, int refusals) {
    if (!corrects_density())
      return nullptr;
    const Vec3<float> a = body_acceleration(settings.forces, time);
    return leftover.allow(executor, particles, dt, refusals, std::sqrt(dot(a, a)));
  }

  /// What is no time at all near the given one, s.
  static double tiny(double end) { return 1e-9 * std::max(1.0, std::abs(end)); }

  /// One accepted step of at most dt; returns its length, s.
  double step(double dt, FrameStatistics& statistics) {
    for (int refusals = 0;; ++refusals, dt = time_step.refused(dt), ++statistics.rejected_steps) {
      walls.move(executor, time, time + dt);
      drift(dt);
      find_neighbours();
      if (surface_tension && surface_tension->apply(context_of(dt, refusals, nullptr)))
        find_neighbours();
      if (viscous() && viscosity.apply(context_of(dt, refusals, nullptr)))
        find_neighbours();
      const StepContext context = context_of(dt, refusals, allowed_leftover(dt, refusals));
      inflow.allow(context, particles.excess.data());
      const StepResult result = solver->solve(context);
      statistics.iterations += result.iterations;
      if (!result.accepted)
        continue;
      statistics.contacts += integrate(context, result.pressure_factor, statistics);
      solver->ease(context);
      note_leftover(particles.corrected_position);
      summed_time += context.kick;
      if (frame_end - (time + dt) <= tiny(frame_end))
        measure_pressure(context, settings.solver.pressure_kernel, summed_time);
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
    const ContactView contact = walls.contact();
    inflow.mark(particles);
    const float* carried = inflow.held();
    const Moved motion = executor.reduce<Moved>("drift", particles.count, [=](std::uint32_t i) {
      const Vec3<float> velocity = v[i] + dv;
      const Vec3<float> free = x[i] + step * velocity;
      const Vec3<float> stopped = contact.resolve(x[i], free);
      const Vec3<float> push = stopped - free;
      drifted_x.set(i, stopped);
      drifted_v.set(i, velocity + (1 / step) * push);
      if (carried != nullptr && carried[i] > 0)
        return Moved{};
      return Moved{0, dot(push, push) > 0, 0, wall_impulse(contact, stopped, push, step)};
    });
    drift_contacts = motion.contacts;
    drift_impulse = motion.wall_impulse;
    inflow.carry(executor, particles, time + dt);
  }

  /// A contact's change of velocity times the wall's velocity, m²/s².
  static double wall_impulse(const ContactView& contact, const Vec3<float>& stopped,
                             const Vec3<float>& push, float time_step) {
    if (contact.bodies.empty() || !(dot(push, push) > 0))
      return 0;
    return double{dot(push, contact.velocity_behind(stopped, push))} / double{time_step};
  }

  /// Takes over the corrected positions; returns how many particles were stopped by a surface.
  std::int64_t integrate(const StepContext& s, float pressure_factor, FrameStatistics& statistics) {
    const Vec3Arrays x = particles.position.view(), v = particles.velocity.view(),
                     drifted_x = particles.drifted_position.view(),
                     drifted_v = particles.drifted_velocity.view(),
                     corrected = particles.corrected_position.view(),
                     a = particles.acceleration.view();
    float *pressure = particles.pressure.data(), *new_pressure = particles.step_pressure.data(),
          *sum = particles.mean_pressure.data();
    const float dt = s.time_step;
    const ContactView contact = s.contact;
    const Moved motion =
        executor.reduce<Moved>("integrate", particles.count, [=, &s](std::uint32_t i) {
          const Vec3<float> free = drifted_x[i] + (dt * dt) * a[i];
          const Vec3<float> push = corrected[i] - free;
          const Vec3<float> velocity = drifted_v[i] + dt * a[i] + (1 / dt) * push;
          if (s.alone(i))  // if it was not alone before, it may be nearer; no velocity comes of it
            corrected.set(i, s.contact.resolve_off_walls(corrected[i], s.rest_distance()));
          x.set(i, corrected[i]);
          v.set(i, velocity);
          pressure[i] = pressure_factor * new_pressure[i];
          sum[i] += s.kick * pressure[i];
          return Moved{dot(velocity, velocity), dot(push, push) > 0,
                       double{pressure[i]} * pressure[i],
                       wall_impulse(contact, corrected[i], push, dt)};
        });
    mean_pressure = std::sqrt(motion.squared_pressure / std::max(1u, particles.count));
    const BoundaryView& solid = s.boundary;
    if (walls.move())
      statistics.wall_work +=
          double{constants.rest_density} * constants.volume *
              (motion.wall_impulse + drift_impulse) +
          wall_work(executor, constants, settings.solver.pressure_kernel, particles, solid, dt);
    for (std::uint32_t k = 0; k < solid.wet_count; ++k) {
      const std::uint32_t b = solid.wet[k];
      solid.pressure[b] = pressure_factor * solid.step_pressure[b];
      solid.mean_pressure[b] += s.kick * solid.pressure[b];
    }
    max_speed = std::sqrt(motion.squared_speed);
    return motion.contacts + drift_contacts;
  }

  /// What comes and goes at the end of a step, or at the start of a run.
  void exchange_particles() {
    if (!inflow.exists() && !outflow.exists())
      return;
    exchange += outflow.apply(executor, particles, inflow.held());
    exchange += inflow.advance(particles, walls, time, time_step.last(),
                               body_acceleration(settings.forces, time));
    if (inflow.disturbs())
      measure_start();
    max_speed = largest_speed(executor, particles);
  }

  /// Of particles whose density ratios are those at `position`.
  void note_leftover(VectorField& position) {
    if (corrects_density())
      leftover.note(executor, particles, position.view(), neighbourhood.boundary(), constants,
                    inflow.held());
  }

  /// Measures particles as they are given, or where others have come close to them.
  void measure_start() {
    FrameStatistics unused;
    measure(unused);
    note_leftover(particles.drifted_position);
  }

  /// The liquid as it is now.
  void measure(FrameStatistics& statistics) {
    walls.move(executor, time, time);
    const Measured m =
        spindrift::sim::measure(executor, particles, neighbourhood, constants, settings,
                                list_radius_factor * constants.support_radius);
    inflow.mark(particles);
    // The same number for a run in one piece and one that goes on from here.
    mean_pressure = m.rms_pressure;
    statistics.mean_compression = m.mean_compression;
    statistics.max_compression = m.max_compression;
    statistics.max_speed = max_speed;
    statistics.particles = particles.count;
    statistics.kinetic_energy = m.kinetic_energy;
    statistics.potential_energy = m.potential_energy;
  }

  FrameStatistics advance_to(double end, const std::atomic<bool>* stop) {
    FrameStatistics statistics;
    if (time_step.last() == 0) {
      settle(executor, particles, neighbourhood, inflow, constants, settings.solver, map,
             walls.contact(), list_radius_factor * constants.support_radius);
      measure_start();
    }
    frame_end = end;
    if (end - time > tiny(end)) {
      particles.mean_pressure.resize(particles.count);
      particles.mean_pressure.fill(0);
      walls.boundary().mean_pressures().fill(0);
      summed_time = 0;
    }
    while (end - time > tiny(end)) {
      if (stop != nullptr && *stop)
        return statistics;
      const Vec3<float> a = body_acceleration(settings.forces, time);
      const double goal = inflow.next_begin(time, end);
      const double wanted =
          time_step.next(goal - time, fastest(goal), std::sqrt(dot(a, a)), mean_pressure);
      const double dt = step(wanted, statistics);
      time += dt;
      if (end - time <= tiny(end))
        time = end;
      exchange_particles();
      statistics.min_time_step =
          statistics.steps == 0 ? dt : std::min(statistics.min_time_step, dt);
      statistics.max_time_step = std::max(statistics.max_time_step, dt);
      ++statistics.steps;
    }
    time = end;
    measure(statistics);
    note_leftover(particles.drifted_position);
    statistics.exchange = std::exchange(exchange, {});
    return statistics;
  }
};

Simulation::Simulation(const Settings& settings)
    : impl_(std::make_unique<Impl>(settings, fill_volumes(settings))) {
  impl_->exchange_particles();
}

Simulation::Simulation(const Settings& settings, const Frame& start)
    : impl_(std::make_unique<Impl>(settings, fill_volumes(settings))) {
  impl_->check_start(start);
  set_particles(impl_->particles, start);
  impl_->max_speed = largest_speed(impl_->executor, impl_->particles);
  impl_->walls.move(impl_->executor, start.time, start.time);
  impl_->walls.set_pressures(start.boundary_pressures);
  impl_->time = start.time;
  impl_->time_step.set_last(start.last_time_step);
  impl_->inflow.resume(impl_->walls, start.time);
  impl_->measure_start();
}

Simulation::~Simulation() = default;

FrameStatistics Simulation::advance_to(double time, const std::atomic<bool>* stop) {
  return impl_->advance_to(time, stop);
}

Frame Simulation::frame() const {
  Frame frame;
  frame.time = impl_->time;
  frame.last_time_step = impl_->time_step.last();
  frame.boundary_pressures = impl_->walls.pressures();
  put_particles(impl_->particles, impl_->constants.rest_density, frame);
  return frame;
}

std::size_t Simulation::particle_count() const {
  return impl_->particles.count;
}
std::size_t Simulation::boundary_particle_count() const {
  return impl_->walls.boundary().count();
}

std::size_t Simulation::memory_bytes() const {
  return impl_->particles.memory_bytes() + impl_->neighbourhood.memory_bytes() +
         impl_->walls.memory_bytes() + impl_->solver->memory_bytes() +
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
