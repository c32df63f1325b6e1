#include "sim/forces/viscosity.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/conjugate_gradients.hpp"
#include "sim/core/lattice.hpp"
#include "sim/step/velocity_change.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// The largest time step size of the explicit step, s. Velocities relax towards their neighbours'
/// at the rate (μ/ρ₀) Σ w; the fastest mode decays at up to twice that rate, and a step must stay
/// below 2 / (2 rate). Half of that is taken.
double stable_step(const FluidConstants& c, float wall_viscosity, const DiffusionKernel& kernel) {
  double sum = 0;
  for_lattice_points(c.spacing, c.support_radius, [&](const Vec3<float>& p) {
    if (dot(p, p) > 0)
      sum += kernel.weight(dot(p, p));
  });
  const double rate = std::max(c.viscosity, 2 * wall_viscosity) / c.rest_density * sum;
  return rate > 0 ? 0.5 / rate : INFINITY;
}

/// Acceleration of particle i by viscosity, m/s²; zero for a particle in a nozzle, which its
/// neighbours do not slow.
SPINDRIFT_HD Vec3<float> free_acceleration(std::uint32_t i, const StepView& step,
                                           const DiffusionKernel& kernel,
                                           const PointView& velocity) {
  return step.is_held(i) ? Vec3<float>{0, 0, 0}
                         : viscous_acceleration(i, step.constants, kernel, step.drifted, velocity,
                                                step.neighbours, step.boundary);
}

/// The largest wall viscosity of any wall or obstacle, Pa·s.
float largest_wall_viscosity(const Settings& settings) {
  float largest = settings.fluid.wall_viscosity;
  for (const Obstacle& obstacle : settings.obstacles)
    largest = std::max(largest, obstacle.wall_viscosity.value_or(0));
  return largest;
}

/// Computes the velocity changes of an explicit Euler step.
void explicit_step(const StepContext& s, const DiffusionKernel& weights) {
  Particles& p = s.particles;
  const PointView v = p.drifted_velocity.view();
  const Vec3Arrays dv = p.velocity_change().view();
  const StepView step = s.view();
  const DiffusionKernel kernel = weights;
  const float dt = s.time_step();
  s.executor.for_each("viscosity", 1, [=] SPINDRIFT_HD(std::uint32_t) {
    v.set(step.count, {0, 0, 0});
  });
  s.executor.for_each("viscosity", p.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    dv.set(i, dt * free_acceleration(i, step, kernel, v));
  });
}

/// What the implicit step needs from step to step; empty until it is taken first.
struct ImplicitFields {
  VectorField residual, image;  ///< of the conjugate gradients, m/s
  Kept<ConjugateGradients> iteration;
};

/// Backward Euler: (1 − Δt ν∇²) v = v*, solved by conjugate gradients for the change v − v*, whose
/// right side is Δt ν∇² v* (as Weiler et al. 2018 do). The host looks at the iteration only now and
/// then; loops that are begun after its end do nothing.
void implicit_step(const StepContext& s, const DiffusionKernel& weights, ImplicitFields& fields) {
  constexpr int most_iterations = 200;
  constexpr double squared_tolerance = 1e-6;
  constexpr std::string_view phase = "viscosity";
  Particles& p = s.particles;
  const std::uint32_t n = p.count;
  fields.residual.resize(n);
  fields.image.resize(n);
  const Vec3Arrays dv = p.velocity_change().view(), r = fields.residual.view(),
                   image = fields.image.view();
  const PointView direction = p.search_direction().view();
  explicit_step(s, weights);
  StepView step = s.view();
  step.boundary.velocity = {};  // the operator acts on velocity changes: walls have none
  const DiffusionKernel kernel = weights;
  const float dt = s.time_step();
  const auto begin = [=] SPINDRIFT_HD(std::uint32_t i) {
    const Vec3<float> right = dv[i];
    r.set(i, right);
    direction.set(i, right);
    dv.set(i, {0, 0, 0});
    return Sum{double{dot(right, right)}};
  };
  const auto set_goal = [=] SPINDRIFT_HD(ConjugateGradients & it, const Sum& squared) {
    it = ConjugateGradients::to(squared_tolerance, squared.value);
  };
  s.executor.reduce_to<Sum>(phase, n, fields.iteration, begin, set_goal);
  s.executor.for_each(phase, 1, [=] SPINDRIFT_HD(std::uint32_t) { direction.set(n, {0, 0, 0}); });
  for (int k = 0; k < most_iterations; ++k) {
    if (k % Kept<ConjugateGradients>::look_every == 0 && !fields.iteration.look().goes_on)
      return;
    const auto last = fields.iteration.view();
    const auto apply = [=] SPINDRIFT_HD(std::uint32_t i) {
      if (!last->goes_on)
        return Sum{};
      const Vec3<float> d = direction[i];
      const Vec3<float> a = d - dt * free_acceleration(i, step, kernel, direction);
      image.set(i, a);
      return Sum{double{dot(a, d)}};
    };
    const auto find_step = [=] SPINDRIFT_HD(ConjugateGradients & it, const Sum& curvature) {
      it.find_step(curvature.value);
    };
    s.executor.reduce_to<Sum>(phase, n, fields.iteration, apply, find_step);
    const auto found = fields.iteration.view();
    const auto go = [=] SPINDRIFT_HD(std::uint32_t i) {
      if (!found->goes_on)
        return Sum{};
      dv.set(i, dv[i] + found->step * direction[i]);
      const Vec3<float> left = r[i] - found->step * image[i];
      r.set(i, left);
      return Sum{double{dot(left, left)}};
    };
    const auto find_beta = [=] SPINDRIFT_HD(ConjugateGradients & it, const Sum& squared) {
      it.find_beta(squared.value);
    };
    s.executor.reduce_to<Sum>(phase, n, fields.iteration, go, find_beta);
    const auto next = fields.iteration.view();
    s.executor.for_each(phase, n, [=] SPINDRIFT_HD(std::uint32_t i) {
      if (next->goes_on)
        direction.set(i, r[i] + next->beta * direction[i]);
    });
  }
}

class Viscosity final : public Force {
 public:
  /// @param wall_viscosity the largest wall viscosity of any wall or obstacle, Pa·s
  Viscosity(const FluidConstants& constants, float wall_viscosity)
      : kernel_(constants.spacing, constants.support_radius),
        explicit_limit_(stable_step(constants, wall_viscosity, kernel_)) {}

  bool apply(const StepContext& s) override {
    if (s.time_step() <= explicit_limit_)
      explicit_step(s, kernel_);
    else
      implicit_step(s, kernel_, fields_);
    return change_velocities(s, "apply viscosity");
  }

  std::size_t memory_bytes() const override { return bytes_of(fields_.residual, fields_.image); }

 private:
  DiffusionKernel kernel_;
  double explicit_limit_;  ///< largest stable explicit time step, s
  ImplicitFields fields_;
};

}  // namespace

std::unique_ptr<Force> make_viscosity(const Settings& settings, const FluidConstants& constants) {
  const float of_walls = largest_wall_viscosity(settings);
  if (!(constants.viscosity > 0) && !(of_walls > 0))
    return nullptr;
  return std::make_unique<Viscosity>(constants, of_walls);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
