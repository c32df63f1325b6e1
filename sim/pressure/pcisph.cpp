#include "sim/pressure/pcisph.hpp"

#include <cmath>

#include "sim/core/lattice.hpp"
#include "sim/pressure/anderson.hpp"
#include "sim/pressure/coarse_pressure.hpp"
#include "sim/pressure/pcisph_unknowns.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// Share of the last step's pressure that the iteration starts from. Less costs iterations; with
/// all of it, pressure that is no longer needed pushes the liquid apart and makes energy.
constexpr float warm_start = 0.8f;

/// Share of the full correction δ (ρ/ρ₀ − 1) that an iteration applies. On a lattice the
/// correction's operator has eigenvalues up to about 2.4 times its diagonal, so that the full one
/// would not converge.
constexpr float relaxation = 0.45f;

/// Share of the compression left over by a step that easing the positions takes away at once, and
/// the most that counts of it per particle, in units of solver.max_compression.
constexpr float eased = 0.6f, most_eased = 0.15f;

/// Shares of the tolerances of the mean and the largest compression below which liquid without any
/// pressure falls freely.
constexpr float nothing_in_all = 1e-3f, nothing_anywhere = 1e-2f;

/// A step in which pressure moves any particle further than this many spacings has left the
/// neighbourhood it was computed in, and is repeated smaller.
constexpr float largest_correction = 0.4f;

/// A share of a pressure, Pa, or zero where that is less than `least`.
SPINDRIFT_HD inline float part_of(float share, float pressure, float least) {
  const float part = share * pressure;
  return part < least ? 0.f : part;
}

/// Pressure that takes away a share of a compression by easing positions, Pa. Compression below
/// zero counts as far as `pressure` holds it up.
SPINDRIFT_HD inline float easing_pressure(float compression, float pressure, float delta,
                                          float most) {
  return eased * delta * std::clamp(std::max(compression, -pressure / delta), -most, most);
}

/// The solver, with the kernel of the pressure force.
template <class Kernel>
struct Pcisph final : PcisphSolver {
  Pcisph(const SolverSettings& settings, const FluidConstants& constants, const Kernel& kernel)
      : settings_(settings),
        density_kernel_(constants.support_radius),
        pressure_kernel_(kernel),
        gradient_product_(lattice_gradient_product(density_kernel_, kernel, constants.spacing,
                                                   constants.support_radius)),
        coarse_(constants),
        leftover_(settings) {}

  StepResult solve(const StepContext& s) override { return solve(s, leftover_.allow(s)); }

  StepResult solve(const StepContext& s, const Allowance& allowance) override {
    allowance_ = allowance;
    // The eigenvalues of the correction's operator grow with the square of the density.
    const float delta = stiffness(s) / (allowance.densest * allowance.densest);
    const float largest_move = largest_correction * s.constants.spacing;
    acceleration_.start();
    start_pressure(s, delta);
    for (int iteration = 0;; ++iteration) {
      accelerate_and_predict(s, largest_move);
      predict_density(s, delta);
      const Prediction found = prediction_.look();
      if (found.too_far)
        return {.accepted = false, .iterations = iteration};
      const Residual& residual = found.residual;
      const bool falls_freely = found.move == 0 && is_nothing(residual, s);
      if ((falls_freely || iteration >= settings_.min_iterations) && converged(residual, s)) {
        eases_ = !falls_freely;
        return {true, iteration, s.time_step() / s.kick};
      }
      if (iteration == settings_.max_iterations)
        return {.accepted = false, .iterations = iteration};
      const Unknowns unknowns{s.view(), demand(s), s.boundary.wet_count, wet_compression_.data(),
                              delta};
      const AndersonView history = acceleration_.combine(s.executor, unknowns.count(), unknowns);
      if (iteration == 0 && s.refusals < 2)
        correct_everywhere(s, unknowns, history);
      else
        correct_pressure(s, unknowns, history);
      acceleration_.advance();
    }
  }

  void finish(const StepContext& s) override {
    if (eases_)
      ease(s);
    leftover_.note(s, s.particles.corrected_position.view());
  }

  void take_over(const StepContext& s) override {
    leftover_.note(s, s.particles.drifted_position.view());
  }

  /// Eases the positions: moves them, and no velocities, to take away some of the compression that
  /// the step has left over. Updates the density ratios if the moved positions are kept.
  void ease(const StepContext& s) {
    Particles& p = s.particles;
    const float delta = stiffness(s), most = most_eased * settings_.max_compression;
    const float *ratio = p.density_ratio.data(), *pressure = p.pressure.data(),
                *wet = wet_compression_.data();
    const PointView x = p.corrected_position.view(), moved = p.drifted_position.view();
    const StepView step = s.view();
    const Demand demand = this->demand(s);
    s.executor.for_each("ease", p.count + 1, [=] SPINDRIFT_HD(std::uint32_t i) {
      x.value(i) = i == step.count || step.is_held(i)
                       ? 0
                       : easing_pressure(ratio[i] - 1, pressure[i], delta, most);
    });
    s.executor.for_each("ease", s.boundary.wet_count, [=] SPINDRIFT_HD(std::uint32_t k) {
      const BoundaryView& solid = step.boundary;
      const std::uint32_t b = solid.wet[k];
      solid.step_pressure[b] =
          easing_pressure(wet[k] + demand.kept_by_sample(b), solid.pressure[b], delta, most);
    });
    const float dt2 = s.time_step() * s.time_step();
    const Kernel kernel = pressure_kernel_;
    s.executor.for_each("ease", p.count, [=] SPINDRIFT_HD(std::uint32_t i) {
      const Vec3<float> a =
          pressure_acceleration(i, step.constants, kernel, x, step.neighbours, step.boundary);
      moved.set(i, step.is_held(i) ? x[i] : step.contact.resolve(x[i], x[i] + dt2 * a));
    });
    keep_if_better(s, delta);
  }

  float time_step_limit() const override { return settings_.max_time_step; }

  std::size_t memory_bytes() const override {
    return bytes_of(coarse_, acceleration_, wet_compression_);
  }

  /// The pressure per density ratio δ, Pa, of eq. 8 for a full lattice neighbourhood, in which Σ∇W
  /// is zero, with density as a ratio to ρ₀:
  ///   δ = ρ₀ / (Δt² V² Σ ∇W·∇W).
  /// One gradient is that of the density's kernel, the other that of the pressure's.
  float stiffness(const StepContext& s) const {
    const double v_dt = double{s.constants.volume} * s.time_step();
    return static_cast<float>(s.constants.rest_density / (v_dt * v_dt * gradient_product_));
  }

  /// Whether the residual is within the tolerances. A step is not refused for compression that
  /// there was before it. After each refusal the tolerances grow a little: where a step starts at
  /// the very tolerance, a shorter one would not end below it either.
  bool converged(const Residual& residual, const StepContext& s) const {
    const double lenience = 1 + 0.02 * s.refusals;
    const double mean = lenience * settings_.mean_compression * s.particles.count;
    return residual.largest <= lenience * settings_.max_compression &&
           residual.compression <= std::max(mean, allowance_.leftover) &&
           residual.error <= 2 * mean * allowance_.rate;
  }

  /// Whether the residual is so small that liquid without pressure may fall freely.
  bool is_nothing(const Residual& residual, const StepContext& s) const {
    return residual.largest <= nothing_anywhere * settings_.max_compression &&
           residual.error <=
               nothing_in_all * double{settings_.mean_compression} * s.particles.count;
  }

  /// Starts the iteration from a share of the last step's pressure. The pressure that is kept is
  /// the mean over the time between two velocities, the kick; in a step it acts for Δt only, and is
  /// larger by that ratio when Δt shrinks: so a liquid at rest stays at rest when the time step
  /// size changes, and an impact's pressure fits as well. What is too small to matter becomes zero,
  /// so that pressure that dies away does not go through the denormal numbers, on which processors
  /// are a hundred times slower.
  void start_pressure(const StepContext& s, float delta) {
    const float* last = s.particles.pressure.data();
    const PointView at = s.particles.drifted_position.view();
    const float least = 1e-6f * delta, share = warm_start * s.kick / s.time_step();
    const std::uint32_t n = s.particles.count;
    const BoundaryView solid = s.boundary;
    s.executor.for_each("start pressure", n + 1, [=] SPINDRIFT_HD(std::uint32_t i) {
      at.value(i) = i < n ? part_of(share, last[i], least) : 0.f;
    });
    s.executor.for_each("start pressure", solid.wet_count, [=] SPINDRIFT_HD(std::uint32_t k) {
      const std::uint32_t b = solid.wet[k];
      solid.step_pressure[b] = part_of(share, solid.pressure[b], least);
    });
  }

  /// Computes the pressure accelerations and the positions they lead to, and notes how far pressure
  /// moves any particle.
  /// @param largest_move the largest move that the neighbour lists allow, m
  void accelerate_and_predict(const StepContext& s, float largest_move) {
    Particles& p = s.particles;
    const PointView drifted = p.drifted_position.view(), corrected = p.corrected_position.view();
    const Vec3Arrays acceleration = p.acceleration.view();
    const float dt2 = s.time_step() * s.time_step();
    const StepView step = s.view();
    const Kernel kernel = pressure_kernel_;
    const auto accelerate = [=] SPINDRIFT_HD(std::uint32_t i) {
      if (step.is_held(i)) {
        acceleration.set(i, {0, 0, 0});
        corrected.set(i, drifted[i]);
        return Largest{};
      }
      const Vec3<float> a =
          pressure_acceleration(i, step.constants, kernel, drifted, step.neighbours, step.boundary);
      acceleration.set(i, a);
      corrected.set(i, step.moved(i, dt2 * a));
      return Largest{dt2 * dt2 * dot(a, a)};
    };
    const auto note = [=] SPINDRIFT_HD(Prediction & found, const Largest& squared_move) {
      found.move = std::sqrt(squared_move.value);
      found.too_far = !(found.move <= largest_move);
    };
    s.executor.reduce_to<Largest>("pressure acceleration", p.count, prediction_, accelerate, note);
    s.executor.for_each("sentinel", 1, [=] SPINDRIFT_HD(std::uint32_t) {
      corrected.set(step.count, {sentinel_position, sentinel_position, sentinel_position});
    });
  }

  /// Computes the density ratios at the predicted positions, and the residual. A particle under
  /// pressure must be at the rest density, neither above nor below it: expansion held up by
  /// pressure is an error as well.
  void predict_density(const StepContext& s, float delta) {
    Particles& p = s.particles;
    const PointView corrected = p.corrected_position.view(), drifted = p.drifted_position.view();
    float* ratio = p.density_ratio.data();
    const StepView step = s.view();
    const Demand demand = this->demand(s);
    const CubicKernel kernel = density_kernel_;
    const float most = settings_.max_compression;
    // Where liquid that presses on a nozzle has no way out, no step is short enough to move it:
    // after some refusals it is accepted.
    const bool settling = allowance_.settling, can_clear_nozzles = s.refusals < 3;
    const auto so_far = prediction_.view();
    const auto predict = [=] SPINDRIFT_HD(std::uint32_t i) {
      if (so_far->too_far)
        return Residual{};
      ratio[i] =
          density_ratio(i, step.constants, kernel, corrected, step.neighbours, step.boundary);
      const float wanted = demand.compression(i);
      if (step.is_held(i)) {  // compression by walls and others in the nozzle remains
        const float pressed = can_clear_nozzles ? std::max(0.f, wanted) : 0.f;
        return Residual{pressed, pressed, pressed};
      }
      const bool too_dense = demand.excess[i] > most;
      const float compression = std::max(0.f, settling || too_dense ? wanted : ratio[i] - 1.f);
      const float error = std::abs(std::max(wanted, -drifted.value(i) / delta));
      return Residual{compression, error, compression};
    };
    const auto note = [=] SPINDRIFT_HD(Prediction & found, const Residual& residual) {
      found.residual = residual;
    };
    s.executor.reduce_to<Residual>("predict density", p.count, prediction_, predict, note);
    predict_wet_density(s, delta);
  }

  /// Computes the compressions of the wet boundary particles at the predicted positions, and adds
  /// their errors to the residual. Without those a pair of particles that lands on a floor bounces.
  void predict_wet_density(const StepContext& s, float delta) {
    const PointView corrected = s.particles.corrected_position.view();
    const StepView step = s.view();
    const Demand demand = this->demand(s);
    const CubicKernel kernel = density_kernel_;
    float* compression = wet_compression_.resized(s.boundary.wet_count);
    const auto so_far = prediction_.view();
    const auto predict = [=] SPINDRIFT_HD(std::uint32_t k) {
      if (so_far->too_far)
        return Sum{};
      const BoundaryView& solid = step.boundary;
      const std::uint32_t b = solid.wet[k];
      compression[k] = boundary_density_ratio(b, step.constants, kernel, corrected, solid) - 1.f -
                       demand.kept_by_sample(b);
      return Sum{std::abs(std::max(compression[k], -solid.step_pressure[b] / delta))};
    };
    const auto note = [=] SPINDRIFT_HD(Prediction & found, const Sum& error) {
      found.residual.error += error.value;
    };
    s.executor.reduce_to<Sum>("predict density", s.boundary.wet_count, prediction_, predict, note);
  }

  /// The first pressure correction of a step: the sum of the coarse grid's, for the liquid as a
  /// whole, and each particle's own.
  void correct_everywhere(const StepContext& s, const Unknowns& unknowns,
                          const AndersonView& history) {
    const float delta = unknowns.delta, part = relaxation * delta;
    coarse_.build(s, delta);
    coarse_.solve(s, [=] SPINDRIFT_HD(std::uint32_t k) {
      return CoarsePressure::Error{unknowns.compression(k), unknowns.pressure(k) / delta};
    });
    const CoarseView coarse = coarse_.view();
    const auto correct = [=] SPINDRIFT_HD(std::uint32_t k, float everywhere) {
      float& p = unknowns.pressure(k);
      history.keep(k, unknowns(k));
      p = std::max(0.f, p + part * unknowns.compression(k) + everywhere);
    };
    s.executor.for_each("correct pressure", s.grid.cell_count,
                        [=] SPINDRIFT_HD(std::uint32_t c) { coarse.at_particles(c, correct); });
    const std::uint32_t n = s.particles.count;
    s.executor.for_each("correct pressure", s.boundary.wet_count,
                        [=] SPINDRIFT_HD(std::uint32_t k) { correct(n + k, coarse.at_wall(k)); });
  }

  /// A later pressure correction, from the best combination with earlier iterations.
  void correct_pressure(const StepContext& s, const Unknowns& unknowns,
                        const AndersonView& history) {
    const float part = relaxation * unknowns.delta;
    s.executor.for_each("correct pressure", unknowns.count(), [=] SPINDRIFT_HD(std::uint32_t k) {
      const AndersonPoint now = unknowns(k), best = history.mixed(k, now);
      history.keep(k, now);
      unknowns.pressure(k) = std::max(0.f, best.iterate + part * best.residual);
    });
  }

  /// Errors of the density ratios before and after the positions are eased.
  struct Errors {
    double before = 0, after = 0;                 ///< sums of squares over the particles
    float largest_before = 0, largest_after = 0;  ///< largest ρ/ρ₀ − 1
    SPINDRIFT_HD void join(const Errors& o) {
      before += o.before;
      after += o.after;
      largest_before = std::max(largest_before, o.largest_before);
      largest_after = std::max(largest_after, o.largest_after);
    }
  };

  /// Takes over the moved positions and their density ratios if these are better. The moved
  /// positions stand in the field of the drifted ones.
  void keep_if_better(const StepContext& s, float delta) {
    Particles& p = s.particles;
    const PointView moved = p.drifted_position.view(), corrected = p.corrected_position.view();
    const Vec3Arrays x = p.position.view();
    float *ratio = p.density_ratio.data(), *moved_ratio = p.eased_density_ratio().data();
    const float* pressure = p.pressure.data();
    const StepView step = s.view();
    const CubicKernel kernel = density_kernel_;
    const auto compare = [=] SPINDRIFT_HD(std::uint32_t i) {
      moved_ratio[i] =
          density_ratio(i, step.constants, kernel, moved, step.neighbours, step.boundary);
      if (step.is_held(i))
        return Errors{};
      const double before = std::max(ratio[i] - 1, -pressure[i] / delta),
                   after = std::max(moved_ratio[i] - 1, -pressure[i] / delta);
      return Errors{before * before, after * after, ratio[i] - 1, moved_ratio[i] - 1};
    };
    const float most = settings_.max_compression;
    const auto judge = [=] SPINDRIFT_HD(bool& better, const Errors& errors) {
      better = !(errors.after > errors.before ||
                 errors.largest_after > std::max(errors.largest_before, most));
    };
    s.executor.reduce_to<Errors>("ease", p.count, better_, compare, judge);
    const auto better = better_.view();
    s.executor.for_each("ease", p.count, [=] SPINDRIFT_HD(std::uint32_t i) {
      if (!*better)
        return;
      x.set(i, moved[i]);
      corrected.set(i, moved[i]);
      ratio[i] = moved_ratio[i];
    });
  }

  Demand demand(const StepContext& s) const {
    return {s.particles.count, s.particles.density_ratio.data(), allowance_.excess,
            s.boundary.compression, allowance_.kept};
  }

 private:
  SolverSettings settings_;
  CubicKernel density_kernel_;
  Kernel pressure_kernel_;
  double gradient_product_;  ///< Σ ∇W·∇W over a full lattice, 1/m⁸
  CoarsePressure coarse_;
  AndersonAcceleration acceleration_;
  Leftover leftover_;
  Allowance allowance_{};        ///< compression that this step may leave
  bool eases_ = false;           ///< whether the last step has left over enough to ease positions
  ScalarField wet_compression_;  ///< as in Unknowns
  Kept<Prediction> prediction_;
  Kept<bool> better_;  ///< whether eased positions are better than those before
};

}  // namespace

std::unique_ptr<PcisphSolver> make_pcisph(const SolverSettings& settings,
                                          const FluidConstants& constants) {
  const float radius = constants.support_radius;
  if (settings.pressure_kernel == PressureKernel::spiky)
    return std::make_unique<Pcisph<SpikyKernel>>(settings, constants, SpikyKernel(radius));
  return std::make_unique<Pcisph<CubicKernel>>(settings, constants, CubicKernel(radius));
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
