// The unknowns of a PCISPH step and the residual of its iteration, as the solver's loops see them.
#pragma once

#include <algorithm>

#include "sim/pressure/anderson.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// The residual of the iteration: sums and maxima over the particles.
struct Residual {
  double compression = 0;  ///< Σ max(0, ρ/ρ₀ − 1)
  /// Σ of how far ρ/ρ₀ is from the wanted value: above it, or below it as far as pressure holds it
  /// up.
  double error = 0;
  float largest = 0;  ///< largest ρ/ρ₀ − 1, at least 0
  SPINDRIFT_HD void join(const Residual& other) {
    compression += other.compression;
    error += other.error;
    largest = std::max(largest, other.largest);
  }
};

/// The compression that a step must take away, as loops see it.
struct Demand {
  std::uint32_t count;         ///< number of particles
  const float* density_ratio;  ///< ρ/ρ₀ of each particle, as last predicted
  const float* excess;         ///< compression that each particle may keep in this step
  const float* of_samples;     ///< compression left over at each boundary particle
  float kept;                  ///< share of it that wet boundary particles may keep

  /// Compression of particle i that the step must take away; below zero it lacks so much.
  SPINDRIFT_HD float compression(std::uint32_t i) const {
    return density_ratio[i] - 1.f - excess[i];
  }
  /// Compression that the wet boundary particle b may keep.
  SPINDRIFT_HD float kept_by_sample(std::uint32_t b) const { return kept * of_samples[b]; }
};

/// The unknowns of a step, with their residuals: the pressures of the fluid particles, then those
/// of the wet boundary particles.
struct Unknowns {
  StepView step;
  Demand demand;
  std::uint32_t wet_count;
  const float* wet_compression;  ///< compression to take away, per wet boundary particle
  float delta;                   ///< pressure per density ratio, δ, Pa

  SPINDRIFT_HD std::uint32_t count() const { return step.count + wet_count; }
  /// The pressure of unknown k, Pa.
  SPINDRIFT_HD float& pressure(std::uint32_t k) const {
    return k < step.count ? step.drifted.value(k)
                          : step.boundary.step_pressure[step.boundary.wet[k - step.count]];
  }
  /// ρ/ρ₀ less the wanted value, for unknown k.
  SPINDRIFT_HD float compression(std::uint32_t k) const {
    return k < step.count ? demand.compression(k) : wet_compression[k - step.count];
  }
  /// Unknown k and its residual, which is bounded below by what takes the pressure to zero.
  SPINDRIFT_HD AndersonPoint operator()(std::uint32_t k) const {
    const float p = pressure(k);
    return {p, std::max(compression(k), -p / delta)};
  }
};

/// The results of one prediction. They live in memory that the loops share (Kept) until all of them
/// are there.
struct Prediction {
  float move = 0;        ///< largest move of any particle by pressure, m
  bool too_far = false;  ///< whether that is further than neighbour lists allow: no residual then
  Residual residual;
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
