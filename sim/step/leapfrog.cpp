#include "sim/step/leapfrog.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// See Motion::wall_power; of one contact.
SPINDRIFT_HD double wall_power(const ContactView& contact, const Vec3<float>& stopped,
                               const Vec3<float>& push, float duration) {
  if (!contact.obstacles.any_moves() || !(dot(push, push) > 0))
    return 0;
  return double{dot(push, contact.obstacles.velocity_behind(stopped, push))} / double{duration};
}

}  // namespace

Motion drift(Executor& executor, Particles& particles, const ContactView& contact,
             const float* held, const Vec3<float>& kick, float duration) {
  const Vec3Arrays x = particles.position.view(), v = particles.velocity.view();
  const PointView drifted_x = particles.drifted_position.view(),
                  drifted_v = particles.drifted_velocity.view();
  const ContactView walls = contact;
  const Vec3<float> dv = kick;
  return executor.reduce<Motion>("drift", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    const Vec3<float> velocity = v[i] + dv;
    const Vec3<float> free = x[i] + duration * velocity;
    const Vec3<float> stopped = walls.resolve(x[i], free, Since::start);
    const Vec3<float> push = stopped - free;
    drifted_x.set(i, stopped);
    drifted_v.set(i, velocity + (1 / duration) * push);
    if (held != nullptr && held[i] > 0)
      return Motion{};
    return Motion{0, dot(push, push) > 0, 0, wall_power(walls, stopped, push, duration)};
  });
}

Motion integrate(const StepContext& s, float pressure_factor) {
  Particles& particles = s.particles;
  const Vec3Arrays x = particles.position.view(), v = particles.velocity.view(),
                   a = particles.acceleration.view();
  const PointView drifted_x = particles.drifted_position.view(),
                  drifted_v = particles.drifted_velocity.view(),
                  corrected = particles.corrected_position.view();
  float *pressure = particles.pressure.data(), *sum = particles.mean_pressure.data();
  const float dt = s.time_step(), kick = s.kick;
  const StepView step = s.view();
  const Motion motion =
      s.executor.reduce<Motion>("integrate", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
        const Vec3<float> free = drifted_x[i] + (dt * dt) * a[i];
        const Vec3<float> push = corrected[i] - free;
        const Vec3<float> velocity = drifted_v[i] + dt * a[i] + (1 / dt) * push;
        // If it was not alone before, it may be nearer; no velocity comes of it.
        if (step.is_alone(i))
          corrected.set(
              i, step.contact.resolve_off_walls(corrected[i], corrected[i], step.rest_distance()));
        x.set(i, corrected[i]);
        v.set(i, velocity);
        pressure[i] = pressure_factor * drifted_x.value(i);
        sum[i] += kick * pressure[i];
        return Motion{dot(velocity, velocity), dot(push, push) > 0,
                      double{pressure[i]} * pressure[i],
                      wall_power(step.contact, corrected[i], push, dt)};
      });
  const BoundaryView solid = s.boundary;
  s.executor.for_each("integrate", solid.wet_count, [=] SPINDRIFT_HD(std::uint32_t k) {
    const std::uint32_t b = solid.wet[k];
    solid.pressure[b] = pressure_factor * solid.step_pressure[b];
    solid.mean_pressure[b] += kick * solid.pressure[b];
  });
  return motion;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
