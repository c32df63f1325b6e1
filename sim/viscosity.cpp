#include "sim/viscosity.hpp"

#include <algorithm>
#include <cmath>

#include "sim/lattice.hpp"
#include "sim/velocity_change.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// Velocities relax towards their neighbours' at the rate (μ/ρ₀) Σ w; the fastest mode decays at up
/// to twice that rate, and a step must stay below 2 / (2 rate). Half of it is taken.
double stable_step(const FluidConstants& c, float wall_viscosity, const DiffusionKernel& kernel) {
  double sum = 0;
  for_lattice_points(c.spacing, c.support_radius, [&](const Vec3<float>& p) {
    if (dot(p, p) > 0)
      sum += kernel.weight(dot(p, p));
  });
  const double rate = std::max(c.viscosity, 2 * wall_viscosity) / c.rest_density * sum;
  return rate > 0 ? 0.5 / rate : INFINITY;
}

/// Acceleration by viscosity, m/s². What a nozzle moves is not slowed by its neighbours.
SPINDRIFT_HD Vec3<float> free_acceleration(std::uint32_t i, const StepView& step,
                                           const DiffusionKernel& kernel,
                                           const PointView& velocity) {
  return step.is_held(i) ? Vec3<float>{0, 0, 0}
                         : viscous_acceleration(i, step.constants, kernel, step.drifted, velocity,
                                                step.neighbours, step.boundary);
}

}  // namespace

Viscosity::Viscosity(const FluidConstants& constants, float wall_viscosity)
    : support_radius_(constants.support_radius),
      kernel_(constants.spacing, constants.support_radius),
      explicit_limit_(stable_step(constants, wall_viscosity, kernel_)) {}

bool Viscosity::apply(const StepContext& s) {
  if (s.time_step <= explicit_limit_)
    explicit_step(s);
  else
    implicit_step(s);
  return change_velocities(s, "apply viscosity");
}

/// Leaves the change of velocity in `acceleration`.
void Viscosity::explicit_step(const StepContext& s) {
  Particles& p = s.particles;
  const PointView v = p.drifted_velocity.view();
  const Vec3Arrays dv = p.acceleration.view();
  const StepView step = s.view();
  const DiffusionKernel kernel = kernel_;
  const float dt = s.time_step;
  s.executor.for_each("viscosity", 1, [=] SPINDRIFT_HD(std::uint32_t) {
    v.set(step.count, {0, 0, 0});
  });
  s.executor.for_each("viscosity", p.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    dv.set(i, dt * free_acceleration(i, step, kernel, v));
  });
}

/// Backward Euler: (1 − Δt ν∇²) v = v*, solved by conjugate gradients for the change v − v*, whose
/// right side is Δt ν∇² v* (as Weiler et al. 2018 do).
void Viscosity::implicit_step(const StepContext& s) {
  constexpr int most_iterations = 200;
  constexpr double squared_tolerance = 1e-6;
  Particles& p = s.particles;
  const std::uint32_t n = p.count;
  residual_.resize(n);
  image_.resize(n);
  const Vec3Arrays dv = p.acceleration.view(), r = residual_.view(), image = image_.view();
  const PointView direction = p.corrected_position.view();
  explicit_step(s);
  StepView step = s.view();
  step.boundary.velocity = {};  // a change of velocity does not meet the walls' own
  const DiffusionKernel kernel = kernel_;
  const float dt = s.time_step;
  double squared = s.executor
                       .reduce<Sum>("viscosity", n,
                                    [=] SPINDRIFT_HD(std::uint32_t i) {
                                      const Vec3<float> right = dv[i];
                                      r.set(i, right);
                                      direction.set(i, right);
                                      dv.set(i, {0, 0, 0});
                                      return Sum{double{dot(right, right)}};
                                    })
                       .value;
  s.executor.for_each("viscosity", 1, [=] SPINDRIFT_HD(std::uint32_t) {
    direction.set(n, {0, 0, 0});
  });
  const double goal = squared_tolerance * squared;
  for (int k = 0; k < most_iterations && squared > goal; ++k) {
    const double curvature =
        s.executor
            .reduce<Sum>("viscosity", n,
                         [=] SPINDRIFT_HD(std::uint32_t i) {
                           const Vec3<float> d = direction[i];
                           const Vec3<float> a =
                               d - dt * free_acceleration(i, step, kernel, direction);
                           image.set(i, a);
                           return Sum{double{dot(a, d)}};
                         })
            .value;
    if (!(curvature > 0))
      return;
    const float way = static_cast<float>(squared / curvature);
    const double next = s.executor
                            .reduce<Sum>("viscosity", n,
                                         [=] SPINDRIFT_HD(std::uint32_t i) {
                                           dv.set(i, dv[i] + way * direction[i]);
                                           const Vec3<float> left = r[i] - way * image[i];
                                           r.set(i, left);
                                           return Sum{double{dot(left, left)}};
                                         })
                            .value;
    const float beta = static_cast<float>(next / squared);
    squared = next;
    s.executor.for_each("viscosity", n, [=] SPINDRIFT_HD(std::uint32_t i) {
      direction.set(i, r[i] + beta * direction[i]);
    });
  }
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
