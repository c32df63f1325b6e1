#include "sim/pcisph.hpp"

#include <cmath>

#include "sim/lattice.hpp"

namespace spindrift::sim {
namespace {

/// Part of the last step's pressure that the iteration starts from. Less costs iterations; with all
/// of it, pressure that is no longer needed pushes the liquid apart and makes energy.
constexpr float warm_start = 0.9f;

/// Part of the full correction δ (ρ/ρ₀ − 1) that an iteration applies. The correction's operator
/// has, on a lattice, eigenvalues up to about 2.4 times its diagonal, so that the full one would
/// not converge; accelerated gradient steps are stable up to the inverse of that. The rest is a
/// margin for disorder and walls: with more, iterations to a tight tolerance diverge in places, and
/// their steps are repeated.
constexpr float relaxation = 0.36f;

/// A step in which pressure moves any particle further than this many spacings has left the
/// neighbourhood it was computed in, and is repeated smaller.
constexpr float largest_correction = 0.4f;

/// How far the iteration is from its end.
struct Residual {
  double sum =
      0;  ///< of |ρ/ρ₀ − 1| over compressed particles, and over expanded ones under pressure
  float compression = 0;  ///< largest ρ/ρ₀ − 1
  void join(const Residual& other) {
    sum += other.sum;
    compression = std::max(compression, other.compression);
  }
};

struct Sum {
  double value = 0;
  void join(const Sum& other) { value += other.value; }
};

struct Largest {
  float value = 0;
  void join(const Largest& other) { value = std::max(value, other.value); }
};

/// Weights of the accelerated projected gradient method (Beck & Teboulle 2009, FISTA, eqs. 4.2
/// and 4.3).
class Momentum {
 public:
  float next() {
    const float t = 0.5f * (1 + std::sqrt(1 + 4 * t_ * t_));
    const float weight = (t_ - 1) / t;
    t_ = t;
    return weight;
  }

 private:
  float t_ = 1;
};

template <class Kernel>
class Pcisph : public PressureSolver {
 public:
  Pcisph(const SolverSettings& settings, const FluidConstants& constants, const Kernel& kernel)
      : settings_(settings),
        density_kernel_(constants.support_radius),
        pressure_kernel_(kernel),
        gradient_product_(lattice_gradient_product(density_kernel_, kernel, constants.spacing,
                                                   constants.support_radius)) {}

  StepResult solve(const StepContext& s) override {
    // The eigenvalues grow with the square of the density.
    const float delta = relaxation * stiffness(s) / (s.densest * s.densest);
    const float largest_move = largest_correction * s.constants.spacing;
    Momentum momentum;
    start_pressure(s, delta);
    for (int iteration = 0;; ++iteration) {
      const float move = accelerate_and_predict(s);
      if (!(move <= largest_move))
        return {.accepted = false, .iterations = iteration};
      const Residual residual = predict_density(s, delta);
      if (iteration >= settings_.min_iterations && converged(residual, s.particles.count))
        return {true, iteration, s.time_step / s.kick};
      if (iteration == settings_.max_iterations)
        return {.accepted = false, .iterations = iteration};
      const float weight = momentum.next();
      if (correct_pressure(s, delta, weight) < 0)
        momentum = Momentum();
      correct_boundary_pressure(s, delta, weight);
    }
  }

  float time_step_limit() const override { return settings_.max_time_step; }

 private:
  /// δ of eq. 8 for a full lattice neighbourhood, where Σ∇W = 0, with density as a ratio to ρ₀:
  ///   δ = ρ₀ / (Δt² V² Σ ∇W·∇W), Pa. One gradient is density's kernel's, the other pressure's.
  float stiffness(const StepContext& s) const {
    const double v_dt = double{s.constants.volume} * s.time_step;
    return static_cast<float>(s.constants.rest_density / (v_dt * v_dt * gradient_product_));
  }

  bool converged(const Residual& residual, std::uint32_t count) const {
    return residual.compression <= settings_.max_compression &&
           residual.sum <= double{settings_.mean_compression} * count;
  }

  /// A part of the last step's pressure. The pressure that is kept is the mean over the time
  /// between two velocities, the kick; in a step it acts for Δt only, and is larger by that ratio
  /// when Δt shrinks: so a liquid at rest stays there when steps change length, and an impact's
  /// pressure fits as well. What is too small to matter becomes zero, so that pressure that dies
  /// away does not go through the denormal numbers, on which processors are a hundred times slower.
  void start_pressure(const StepContext& s, float delta) {
    const float* last = s.particles.pressure.data();
    float* p = s.particles.step_pressure.data();
    float* before = before_.resized(s.particles.count);
    const float least = 1e-6f * delta, share = warm_start * s.kick / s.time_step;
    const auto part_of = [=](float pressure) {
      const float part = share * pressure;
      return part < least ? 0.f : part;
    };
    s.executor.for_each("start pressure", s.particles.count,
                        [=](std::uint32_t i) { p[i] = before[i] = part_of(last[i]); });
    p[s.particles.count] = 0;
    float* solid_before = boundary_before_.resized(s.boundary.count);
    for (std::uint32_t k = 0; k < s.boundary.wet_count; ++k) {
      const std::uint32_t b = s.boundary.wet[k];
      s.boundary.step_pressure[b] = solid_before[b] = part_of(s.boundary.pressure[b]);
    }
  }

  /// Pressure acceleration and the position it leads to; returns how far pressure moves a particle
  /// at most, m.
  float accelerate_and_predict(const StepContext& s) {
    Particles& p = s.particles;
    const Vec3Arrays drifted = p.drifted_position.view(), corrected = p.corrected_position.view(),
                     acceleration = p.acceleration.view();
    const float* pressure = p.step_pressure.data();
    const float dt2 = s.time_step * s.time_step;
    const Largest squared_move =
        s.executor.reduce<Largest>("pressure acceleration", p.count, [&](std::uint32_t i) {
          const Vec3<float> a = pressure_acceleration(i, s.constants, pressure_kernel_, drifted,
                                                      pressure, s.neighbours, s.boundary);
          acceleration.set(i, a);
          corrected.set(i, s.contact.resolve(drifted[i] + dt2 * a));
          return Largest{dt2 * dt2 * dot(a, a)};
        });
    corrected.set(p.count, {sentinel_position, sentinel_position, sentinel_position});
    return std::sqrt(squared_move.value);
  }

  /// Density where the particles are predicted to be. A particle under pressure must be at the rest
  /// density, neither above nor below it: expansion held up by pressure is an error as well.
  Residual predict_density(const StepContext& s, float delta) {
    Particles& p = s.particles;
    const Vec3Arrays corrected = p.corrected_position.view();
    const float* pressure = p.step_pressure.data();
    float* ratio = p.density_ratio.data();
    const float* excess = s.excess;
    return s.executor.reduce<Residual>("predict density", p.count, [&](std::uint32_t i) {
      ratio[i] =
          density_ratio(i, s.constants, density_kernel_, corrected, s.neighbours, s.boundary);
      const float compression = ratio[i] - 1.f - (excess ? excess[i] : 0.f);
      const float releasable = std::min(-compression, pressure[i] / delta);
      return Residual{std::max(compression, releasable), std::max(0.f, compression)};
    });
  }

  /// One accelerated, projected gradient step. It is the accumulated pressure that is kept from
  /// falling below zero, not the increment.
  static float corrected_pressure(float pressure, float compression, float delta, float weight,
                                  float& before) {
    const float p = std::max(0.f, pressure + delta * compression);
    const float ahead = p + weight * (p - before);
    before = p;
    return std::max(0.f, ahead);
  }

  /// Returns Σ (ρ/ρ₀ − 1) Δp: negative when the momentum has carried the pressure beyond its goal,
  /// and is to start anew (O'Donoghue & Candès 2015, gradient scheme).
  double correct_pressure(const StepContext& s, float delta, float weight) {
    const float *ratio = s.particles.density_ratio.data(), *excess = s.excess;
    float *p = s.particles.step_pressure.data(), *before = before_.data();
    return s.executor
        .reduce<Sum>("correct pressure", s.particles.count,
                     [=](std::uint32_t i) {
                       const float compression = ratio[i] - 1.f - (excess ? excess[i] : 0.f),
                                   last = before[i];
                       p[i] = corrected_pressure(p[i], compression, delta, weight, before[i]);
                       return Sum{double{compression} * (before[i] - last)};
                     })
        .value;
  }

  void correct_boundary_pressure(const StepContext& s, float delta, float weight) {
    const Vec3Arrays corrected = s.particles.corrected_position.view();
    const BoundaryView& solid = s.boundary;
    s.executor.for_each("boundary pressure", solid.wet_count, [&](std::uint32_t k) {
      const std::uint32_t b = solid.wet[k];
      const float ratio = boundary_density_ratio(b, s.constants, density_kernel_, corrected, solid);
      solid.step_pressure[b] = corrected_pressure(solid.step_pressure[b], ratio - 1.f, delta,
                                                  weight, boundary_before_[b]);
    });
  }

  SolverSettings settings_;
  CubicKernel density_kernel_;
  Kernel pressure_kernel_;
  double gradient_product_;               ///< Σ ∇W·∇W over a full lattice, 1/m⁸
  ScalarField before_, boundary_before_;  ///< pressures of the iteration before, Pa
};

}  // namespace

std::unique_ptr<PressureSolver> make_pcisph(const SolverSettings& settings,
                                            const FluidConstants& constants) {
  const float radius = constants.support_radius;
  if (settings.pressure_kernel == PressureKernel::spiky)
    return std::make_unique<Pcisph<SpikyKernel>>(settings, constants, SpikyKernel(radius));
  return std::make_unique<Pcisph<CubicKernel>>(settings, constants, CubicKernel(radius));
}

}  // namespace spindrift::sim
