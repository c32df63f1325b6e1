#include "sim/leftover.hpp"

#include <algorithm>
#include <cmath>

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// Time over which what is left over is taken away, in √(H/g).
constexpr double release_time = 0.1;

/// Part of the tolerance of the mean up to which compression of many particles together may be
/// kept, so that a step does not start at its tolerance.
constexpr float largest_together = 0.3f;

/// Part that is kept of the compression of a particle that is denser than it may be, as where
/// others reach one that walls alone had held.
constexpr float kept_if_too_dense = 0.9f;

/// Steps of this length, in √(H/g), and longer ones may add the whole tolerance; shorter ones a
/// part, at least the second number.
constexpr double full_rate_time = 0.04, least_rate = 0.5;

}  // namespace

void Leftover::note(Executor& executor, Particles& particles, const float* held) {
  const float *ratio = particles.density_ratio.data(), *pressure = particles.pressure.data();
  float* compression = particles.compression.resized(particles.count);
  executor.for_each("leftover", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    const bool carried = held != nullptr && held[i] > 0;
    const float c = carried ? 0 : ratio[i] - 1;
    compression[i] = pressure[i] > 0 ? c : std::max(0.f, c);
  });
}

const float* Leftover::allow(Executor& executor, Particles& particles, CellGridView grid, double dt,
                             int refusals, float acceleration) {
  // Where nothing falls, there is no such time.
  const double fall = std::sqrt(double{support_radius_} / acceleration);
  const double taken = std::min(1., dt / std::min(20 * dt, release_time * fall));
  // Repeating a step does not ask for more than the step did.
  const double first_dt = dt * std::pow(2., refusals);
  rate_ = acceleration > 0
              ? static_cast<float>(std::clamp(first_dt / (full_rate_time * fall), least_rate, 1.))
              : 1;
  const auto kept = static_cast<float>(1 - taken);
  const float most = settings_.max_compression,
              most_together = largest_together * settings_.mean_compression;
  const float* compression = particles.compression.data();
  float* excess = particles.excess.resized(particles.count);
  executor.for_each("leftover", static_cast<std::uint32_t>(grid.cell_count),
                    [=] SPINDRIFT_HD(std::uint32_t k) {
                      const std::uint32_t begin = grid.cell_begin(k), end = grid.cell_begin(k + 1);
                      float sum = 0;
                      for (std::uint32_t i = begin; i < end; ++i)
                        sum += compression[i];
                      const float mean = sum / static_cast<float>(end - begin);
                      const float together = std::clamp(kept * mean, -most_together, most_together);
                      for (std::uint32_t i = begin; i < end; ++i) {
                        const float c = compression[i];
                        excess[i] = kept_if_too_dense * c > most ? kept_if_too_dense * c : together;
                      }
                    });
  return excess;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
