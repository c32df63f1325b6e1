// What a PCISPH step looks for, and how far an iteration is from it, as loops see them.
#pragma once

#include <algorithm>

#include "sim/pressure/anderson.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// How far the iteration is from its end.
struct Residual {
  double compression = 0;  ///< Σ max(0, ρ/ρ₀ − 1)
  double error = 0;  ///< Σ of how far ρ/ρ₀ is from what is wanted, above it, or below it as far
                     ///< as pressure holds it up
  float largest = 0;  ///< ρ/ρ₀ − 1
  SPINDRIFT_HD void join(const Residual& other) {
    compression += other.compression;
    error += other.error;
    largest = std::max(largest, other.largest);
  }
};

/// What a step must take away, as loops look at it.
struct Demand {
  std::uint32_t count;         ///< particles
  const float* density_ratio;  ///< ρ/ρ₀, as last predicted
  const float* excess;         ///< compression that a particle may keep in this step
  const float* of_samples;     ///< compression left over at the boundary samples
  float kept;                  ///< part of it that wet ones may keep

  /// Compression of a particle that the step must take away, or, below zero, lacks.
  SPINDRIFT_HD float compression(std::uint32_t i) const {
    return density_ratio[i] - 1.f - excess[i];
  }
  /// Compression that wet sample b may keep.
  SPINDRIFT_HD float kept_by_sample(std::uint32_t b) const { return kept * of_samples[b]; }
};

/// The unknowns of a step, and what is wrong with them: the pressures of the particles, then of the
/// wet boundary samples.
struct Unknowns {
  StepView step;
  Demand demand;
  std::uint32_t wet_count;
  const float* wet_compression;
  float delta;  ///< pressure per density ratio, δ, Pa

  SPINDRIFT_HD std::uint32_t count() const { return step.count + wet_count; }
  /// Pa.
  SPINDRIFT_HD float& pressure(std::uint32_t k) const {
    return k < step.count ? step.drifted.value(k)
                          : step.boundary.step_pressure[step.boundary.wet[k - step.count]];
  }
  /// ρ/ρ₀ less what is wanted.
  SPINDRIFT_HD float compression(std::uint32_t k) const {
    return k < step.count ? demand.compression(k) : wet_compression[k - step.count];
  }
  /// Where pressure would have to fall below zero the residual ends at what takes it to zero.
  SPINDRIFT_HD AndersonPoint operator()(std::uint32_t k) const {
    const float p = pressure(k);
    return {p, std::max(compression(k), -p / delta)};
  }
};

/// What one prediction finds; it stays where the loops are until all of it is there.
struct Prediction {
  float move = 0;        ///< how far pressure moves a particle at most, m
  bool too_far = false;  ///< further than the neighbourhood reaches: the residual is not looked for
  Residual residual;
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
