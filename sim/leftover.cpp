#include "sim/leftover.hpp"

#include <algorithm>
#include <cmath>

namespace spindrift::sim {
namespace {

struct Compression {
  double sum = 0;
  float largest = 0;
  void join(const Compression& o) {
    sum += o.sum;
    largest = std::max(largest, o.largest);
  }
};

/// Overlapping particles are moved apart this much slower than other leftovers are taken away.
constexpr double overlap_slowness = 200;

/// Time over which what many particles have left over together is taken away, in √(H/g).
constexpr double time_together = 0.1;

/// Steps of this length, in √(H/g), and longer ones may add the whole tolerance; shorter ones a
/// part, at least the second number.
constexpr double full_rate_time = 0.04, least_rate = 0.5;

}  // namespace

void Leftover::note(Executor& executor, Particles& particles, const float* held,
                    bool after_a_step) {
  const float *ratio = particles.density_ratio.data(), *pressure = particles.pressure.data();
  float* compression = particles.compression.resized(particles.count);
  const auto total =
      executor.reduce<Compression>("leftover", particles.count, [=](std::uint32_t i) {
        const bool carried = held != nullptr && held[i] > 0;
        const float c = carried ? 0 : ratio[i] - 1, above = std::max(0.f, c);
        compression[i] = pressure[i] > 0 ? c : above;
        return Compression{above, above};
      });
  const double mean = total.sum / std::max(1u, particles.count);
  // What steps add within their tolerance must not add up.
  left_to_release_ = after_a_step && overlapping_ ? std::min(mean, kept_ * left_to_release_) : mean;
  share_ = mean > 0 ? left_to_release_ / mean : 1;
  densest_ = 1 + total.largest;
  constexpr double far = 1.1;
  overlapping_ =
      total.largest > far * settings_.max_compression || mean > far * settings_.mean_compression;
}

const float* Leftover::allow(Executor& executor, Particles& particles, const CellGrid& grid,
                             double dt, int refusals, float acceleration) {
  const float* compression = particles.compression.data();
  float* excess = particles.excess.resized(particles.count);
  // Where nothing falls, the number of steps decides.
  const double fall = std::sqrt(double{support_radius_} / acceleration);
  const double taken = std::min(1., dt / std::min(20 * dt, time_together * fall));
  // Repeating a step does not ask for more than the step did.
  const double first_dt = dt * std::pow(2., refusals);
  rate_ = acceleration > 0 && !overlapping_
              ? static_cast<float>(std::clamp(first_dt / (full_rate_time * fall), least_rate, 1.))
              : 1;
  if (overlapping_) {
    kept_ = 1 - taken / overlap_slowness * std::pow(0.5, refusals);
    const auto part = static_cast<float>(kept_ * share_);
    executor.for_each("leftover", particles.count,
                      [=](std::uint32_t i) { excess[i] = part * std::max(0.f, compression[i]); });
    return excess;
  }
  const float most = 0.3f * settings_.mean_compression;
  const auto cells = static_cast<std::uint32_t>(grid.cell_count());
  executor.for_each("leftover", cells, [&](std::uint32_t c) {
    const std::uint32_t begin = grid.cell_begin(c), end = grid.cell_begin(c + 1);
    float sum = 0;
    for (std::uint32_t i = begin; i < end; ++i)
      sum += compression[i];
    const float mean = sum / static_cast<float>(end - begin);
    std::fill(excess + begin, excess + end,
              std::clamp(static_cast<float>(1 - taken) * mean, -most, most));
  });
  return excess;
}

}  // namespace spindrift::sim
