#include "sim/run/engine.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "sim/boundary/neighbourhood.hpp"
#include "sim/boundary/walls.hpp"
#include "sim/flow/inflow.hpp"
#include "sim/flow/outflow.hpp"
#include "sim/forces/force.hpp"
#include "sim/particles/particle_state.hpp"
#include "sim/pressure/creep.hpp"
#include "sim/pressure/pcisph.hpp"
#include "sim/pressure/settle.hpp"
#include "sim/pressure/wcsph.hpp"
#include "sim/start/initial.hpp"
#include "sim/step/measure.hpp"
#include "sim/step/time_step.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// Neighbours are listed a little beyond the support radius, since pressure moves particles on from
/// where the lists were made.
constexpr float list_radius_factor = 1.05f;

struct Moved {
  float squared_speed = 0;
  std::int64_t contacts = 0;
  double squared_pressure = 0;
  double wall_impulse = 0;  ///< Σ of what contacts change velocities by, times the walls', m²/s²
  SPINDRIFT_HD void join(const Moved& o) {
    squared_speed = std::max(squared_speed, o.squared_speed);
    contacts += o.contacts;
    squared_pressure += o.squared_pressure;
    wall_impulse += o.wall_impulse;
  }
};

/// A contact's change of velocity times the wall's velocity, m²/s².
SPINDRIFT_HD double wall_impulse(const ContactView& contact, const Vec3<float>& stopped,
                                 const Vec3<float>& push, float time_step) {
  if (!contact.obstacles.any_moves() || !(dot(push, push) > 0))
    return 0;
  return double{dot(push, contact.obstacles.velocity_behind(stopped, push))} / double{time_step};
}

struct Run final : Engine {
  Settings settings;
  FluidConstants constants;
  Executor executor;
  Particles particles;
  GridMap map;
  Walls walls;
  Neighbourhood neighbourhood;
  float speed_of_sound;  ///< of basic SPH, m/s
  std::unique_ptr<PressureSolver> solver;
  std::vector<std::unique_ptr<Force>> forces;
  TimeStepControl time_step;
  double time = 0;
  double frame_end = 0;    ///< s
  double summed_time = 0;  ///< over which Particles::mean_pressure sums, s
  float max_speed = 0;
  double mean_pressure = 0;  ///< root mean square over the particles, Pa
  std::int64_t drift_contacts = 0;
  double drift_impulse = 0;  ///< as Moved::wall_impulse
  Inflow inflow;
  Outflow outflow;
  Exchange exchange;           ///< since the last frame
  std::optional<Creep> creep;  ///< until it is done
  bool has_settled = false;    ///< once, before time begins

  Run(const Settings& s, const InitialParticles& initial, Stop stop)
      : settings(s),
        constants(constants_of(s.fluid)),
        map(grid_over(s, list_radius_factor * constants.support_radius)),
        walls(s, map, constants.support_radius, stop),
        neighbourhood(map, walls.boundary()),
        speed_of_sound(speed_of_sound_in(s, initial)),
        solver(make_solver(s.solver)),
        forces(forces_of(s, constants)),
        time_step(s.solver, constants, time_step_limit()),
        inflow(s, constants, static_cast<std::uint32_t>(initial.positions.size())),
        outflow(s, constants) {
    if (initial.positions.empty() && !inflow.exists())
      throw std::invalid_argument(
          "the scene has no particles: no volume is as wide as fluid.spacing, and there is no "
          "emitter");
    executor.obey(stop);
    executor.check_room(initial.positions.size(), constants.spacing);
    set_particles(executor, particles, initial);
    max_speed = largest_speed(executor, particles);
    inflow.attach(walls);
    walls.move(executor, 0, 0);
    if (!initial.loose.empty())
      creep.emplace(initial, inflow.next_id(0));
  }

  /// 0 where nothing asks for it.
  static float speed_of_sound_in(const Settings& s, const InitialParticles& initial) {
    if (s.solver.type != SolverType::sph || s.solver.speed_of_sound > 0)
      return s.solver.speed_of_sound;
    return default_speed_of_sound(s, initial);
  }

  std::unique_ptr<PressureSolver> make_solver(const SolverSettings& s) const {
    if (s.type == SolverType::pcisph)
      return make_pcisph(s, constants);
    return make_wcsph(s, constants, speed_of_sound);
  }

  /// @throws std::invalid_argument for a frame that is not one of these settings'
  void check_start(const Frame& start) const {
    const std::size_t n = start.positions.size();
    if (n != particles.count && !inflow.exists() && !outflow.exists())
      throw std::invalid_argument("cannot go on from a frame of " + std::to_string(n) +
                                  " particles: the scene has " + std::to_string(particles.count));
    const std::uint32_t end = inflow.next_id(start.time);
    if (std::any_of(start.ids.begin(), start.ids.end(), [&](auto id) { return id >= end; }))
      throw std::invalid_argument("cannot go on from a frame with a particle of a number above " +
                                  std::to_string(end) + ": the scene has none yet");
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

  /// Of the solver and of all forces, s.
  float time_step_limit() const {
    float limit = solver->time_step_limit();
    for (const auto& force : forces)
      limit = std::min(limit, force->time_step_limit());
    return limit;
  }

  void find_neighbours() {
    neighbourhood.update(executor, particles, list_radius_factor * constants.support_radius);
  }

  StepContext context_of(double dt, int refusals) {
    const Vec3<float> a = body_acceleration(settings.forces, time);
    return {.executor = executor,
            .particles = particles,
            .constants = constants,
            .neighbours = neighbourhood.fluid(),
            .boundary = neighbourhood.boundary(),
            .grid = neighbourhood.grid(),
            .map = &map,
            .contact = walls.contact(),
            .held = inflow.held(particles),
            .time_step = static_cast<float>(dt),
            .duration = dt,
            .refusals = refusals,
            .kick = kick(dt),
            .acceleration = std::sqrt(dot(a, a))};
  }

  /// What is no time at all near the given one, s.
  static double tiny(double end) { return 1e-9 * std::max(1.0, std::abs(end)); }

  /// One accepted step of at most dt; returns its length, s.
  double step(double dt, FrameStatistics& statistics) {
    for (int refusals = 0;; ++refusals, dt = time_step.refused(dt), ++statistics.rejected_steps) {
      walls.move(executor, time, time + dt);
      inflow.open_walls(executor, walls, time, time + dt);
      drift(dt);
      find_neighbours();
      for (const auto& force : forces)
        if (force->apply(context_of(dt, refusals)))
          find_neighbours();
      const StepContext context = context_of(dt, refusals);
      const StepResult result = solver->solve(context);
      statistics.iterations += result.iterations;
      if (!result.accepted)
        continue;
      statistics.contacts += integrate(context, result.pressure_factor, statistics);
      solver->finish(context);
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
    const Vec3Arrays x = particles.position.view(), v = particles.velocity.view();
    const PointView drifted_x = particles.drifted_position.view(),
                    drifted_v = particles.drifted_velocity.view();
    const ContactView contact = walls.contact();
    const float* carried = inflow.held(particles);
    const Moved motion =
        executor.reduce<Moved>("drift", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
          const Vec3<float> velocity = v[i] + dv;
          const Vec3<float> free = x[i] + step * velocity;
          const Vec3<float> stopped = contact.resolve(x[i], free, Since::start);
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

  /// Takes over the corrected positions; returns how many particles were stopped by a surface.
  std::int64_t integrate(const StepContext& s, float pressure_factor, FrameStatistics& statistics) {
    const Vec3Arrays x = particles.position.view(), v = particles.velocity.view(),
                     a = particles.acceleration.view();
    const PointView drifted_x = particles.drifted_position.view(),
                    drifted_v = particles.drifted_velocity.view(),
                    corrected = particles.corrected_position.view();
    float *pressure = particles.pressure.data(), *sum = particles.mean_pressure.data();
    const float dt = s.time_step, kick = s.kick;
    const StepView step = s.view();
    const Moved motion =
        executor.reduce<Moved>("integrate", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
          const Vec3<float> free = drifted_x[i] + (dt * dt) * a[i];
          const Vec3<float> push = corrected[i] - free;
          const Vec3<float> velocity = drifted_v[i] + dt * a[i] + (1 / dt) * push;
          // If it was not alone before, it may be nearer; no velocity comes of it.
          if (step.alone(i))
            corrected.set(i, step.contact.resolve_off_walls(corrected[i], corrected[i],
                                                            step.rest_distance()));
          x.set(i, corrected[i]);
          v.set(i, velocity);
          pressure[i] = pressure_factor * drifted_x.value(i);
          sum[i] += kick * pressure[i];
          return Moved{dot(velocity, velocity), dot(push, push) > 0,
                       double{pressure[i]} * pressure[i],
                       wall_impulse(step.contact, corrected[i], push, dt)};
        });
    mean_pressure = std::sqrt(motion.squared_pressure / std::max(1u, particles.count));
    const BoundaryView solid = s.boundary;
    if (walls.move())
      statistics.wall_work +=
          double{constants.rest_density} * constants.volume *
              (motion.wall_impulse + drift_impulse) +
          wall_work(executor, constants, settings.solver.pressure_kernel, particles, solid, dt);
    executor.for_each("integrate", solid.wet_count, [=] SPINDRIFT_HD(std::uint32_t k) {
      const std::uint32_t b = solid.wet[k];
      solid.pressure[b] = pressure_factor * solid.step_pressure[b];
      solid.mean_pressure[b] += kick * solid.pressure[b];
    });
    max_speed = std::sqrt(motion.squared_speed);
    return motion.contacts + drift_contacts;
  }

  /// What comes and goes at the end of a step, or at the start of a run.
  void exchange_particles() {
    if (!inflow.exists() && !outflow.exists())
      return;
    exchange += outflow.apply(executor, particles, inflow.held(particles));
    exchange += inflow.advance(executor, particles, walls, time, time_step.last(),
                               body_acceleration(settings.forces, time));
    if (inflow.disturbs())
      let_in();
    max_speed = largest_speed(executor, particles);
  }

  /// Moves particles apart, without a velocity, where others have come too close to them.
  void let_in() {
    FrameStatistics found;
    measure(found);
    if (has_settled && found.max_compression > settings.solver.max_compression)
      let_apart(Occasion::arrival);
    measure_start();
  }

  void let_apart(Occasion occasion) {
    settle(executor, particles, neighbourhood, inflow, constants, settings.solver, map,
           walls.contact(), list_radius_factor * constants.support_radius, occasion);
  }

  /// Measures particles as they are given, or have been moved.
  void measure_start() {
    FrameStatistics unused;
    measure(unused);
    solver->take_over(context_of(time_step.last(), 0));
  }

  /// The liquid as it is now.
  void measure(FrameStatistics& statistics) {
    walls.move(executor, time, time);
    const Measured m =
        SPINDRIFT_BACKEND::measure(executor, particles, neighbourhood, constants, settings,
                                   list_radius_factor * constants.support_radius);
    // The same number for a run in one piece and one that goes on from here.
    mean_pressure = m.rms_pressure;
    statistics.mean_compression = m.mean_compression;
    statistics.max_compression = m.max_compression;
    statistics.max_speed = max_speed;
    statistics.particles = particles.count;
    statistics.kinetic_energy = m.kinetic_energy;
    statistics.potential_energy = m.potential_energy;
  }

  /// Steps at no time, in which only liquid moves that is not at rest beside bodies.
  void creep_to_rest() {
    const Vec3<float> a = body_acceleration(settings.forces, time);
    const double acceleration = std::sqrt(dot(a, a));
    if (creep && acceleration > 0) {
      const TimeStepControl before = time_step;
      const double dt = std::min(time_step.next(1, 0, acceleration, mean_pressure),
                                 Creep::longest_step(acceleration, constants.spacing));
      FrameStatistics unused;
      frame_end = std::numeric_limits<double>::max();
      particles.mean_pressure.resize(particles.count);
      particles.mean_pressure.fill(0);
      std::unique_ptr<PressureSolver> usual = std::move(solver);
      solver = make_solver(Creep::tightened(settings.solver));
      solver->take_over(context_of(dt, 0));
      creep->begin(executor, particles);
      for (int k = 0; k < Creep::steps; ++k) {
        step(dt, unused);
        creep->end_step(executor, particles);
      }
      creep->end(executor, particles);
      solver = std::move(usual);
      particles.mean_pressure.fill(0);
      walls.boundary().mean_pressures().fill(0);
      time_step = before;
      max_speed = largest_speed(executor, particles);
      measure_start();
    }
    creep.reset();
  }

  FrameStatistics advance_to(double end, Stop stop) override {
    FrameStatistics statistics;
    executor.obey(stop);
    try {
      advance(end, statistics);
    } catch (const Stopped&) {
      // Whoever asked for that knows.
    }
    executor.obey(nullptr);
    return statistics;
  }

  void advance(double end, FrameStatistics& statistics) {
    if (!std::exchange(has_settled, true)) {
      let_apart(Occasion::start);
      measure_start();
      creep_to_rest();
    }
    frame_end = end;
    if (end - time > tiny(end)) {
      particles.mean_pressure.resize(particles.count);
      particles.mean_pressure.fill(0);
      walls.boundary().mean_pressures().fill(0);
      summed_time = 0;
    }
    while (end - time > tiny(end)) {
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
    solver->take_over(context_of(time_step.last(), 0));
    statistics.exchange = std::exchange(exchange, {});
  }

  void go_on_from(const Frame& start) {
    check_start(start);
    set_particles(executor, particles, start);
    max_speed = largest_speed(executor, particles);
    walls.move(executor, start.time, start.time);
    executor.wait();
    walls.set_pressures(start.boundary_pressures);
    time = start.time;
    time_step.resume(start.last_time_step, start.allowed_time_step);
    creep.reset();
    has_settled = true;
    inflow.resume(executor, particles, walls, start.time);
    measure_start();
  }

  std::future<Frame> take_frame() override {
    auto copies = copy_particles(executor, particles, constants.rest_density);
    auto wall_pressures = walls.pressures(executor);
    const auto put_together = [end = time, last = time_step.last(), allowed = time_step.allowed()](
                                  auto of_particles, auto of_walls) {
      Frame frame;
      frame.time = end;
      frame.last_time_step = last;
      frame.allowed_time_step = allowed;
      frame.boundary_pressures = of_walls.take();
      of_particles.put_into(frame);
      return frame;
    };
    return std::async(std::launch::deferred, put_together, std::move(copies),
                      std::move(wall_pressures));
  }

  std::size_t particle_count() const override { return particles.count; }
  std::size_t boundary_particle_count() const override { return walls.boundary().count(); }
  const PhaseClock& clock() const override { return executor.clock(); }

  std::size_t memory_of_forces() const {
    std::size_t sum = 0;
    for (const auto& force : forces)
      sum += force->memory_bytes();
    return sum;
  }

  std::size_t memory_bytes() const override {
    return particles.memory_bytes() + neighbourhood.memory_bytes() + walls.memory_bytes() +
           solver->memory_bytes() + executor.memory_bytes() + memory_of_forces();
  }
};

}  // namespace

std::unique_ptr<Engine> make_engine(const Settings& settings, Stop stop) {
  auto run = std::make_unique<Run>(as_filled(settings), fill_volumes(settings, stop), stop);
  run->exchange_particles();
  run->executor.obey(nullptr);
  return run;
}

std::unique_ptr<Engine> make_engine(const Settings& settings, const Frame& start, Stop stop) {
  auto run = std::make_unique<Run>(as_filled(settings), fill_volumes(settings, stop), stop);
  run->go_on_from(start);
  run->executor.obey(nullptr);
  return run;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
