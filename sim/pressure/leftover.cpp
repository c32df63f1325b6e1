#include "sim/pressure/leftover.hpp"

#include <algorithm>
#include <cmath>

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// Time over which what is left over is taken away, in √(H/g).
constexpr double release_time = 0.08;

/// Part that is kept, at least, of the compression of a particle that is denser than it may be, as
/// where others reach one that walls alone had held.
constexpr float kept_if_too_dense = 0.9f;

/// Steps of this length, in √(H/g), and longer ones may add the whole tolerance; shorter ones a
/// part, at least the second number.
constexpr double full_rate_time = 0.04, least_rate = 0.05;

/// Above the rest density, or a little below it where pressure holds it there. Where there is far
/// less than that, pressure is what an impact left, and nothing to keep up.
SPINDRIFT_HD float counted(float density_ratio, float pressure, float most) {
  return std::max(density_ratio - 1, pressure > 0 ? -most : 0.f);
}

}  // namespace

void Leftover::note(Executor& executor, Particles& particles, const PointView& position,
                    const BoundaryView& boundary, const FluidConstants& constants,
                    const float* held) {
  const float *ratio = particles.density_ratio.data(), *pressure = particles.pressure.data();
  const float most = settings_.max_compression;
  float* compression = particles.compression.resized(particles.count);
  total_ = executor
               .reduce<Sum>("leftover", particles.count,
                            [=] SPINDRIFT_HD(std::uint32_t i) {
                              const bool carried = held != nullptr && held[i] > 0;
                              compression[i] = carried ? 0 : counted(ratio[i], pressure[i], most);
                              return Sum{std::max(0.f, compression[i])};
                            })
               .value;
  const CubicKernel kernel(constants.support_radius);
  const BoundaryView solid = boundary;
  const PointView at = position;
  const FluidConstants c = constants;
  executor.for_each("leftover", boundary.wet_count, [=] SPINDRIFT_HD(std::uint32_t k) {
    const std::uint32_t b = solid.wet[k];
    solid.compression[b] =
        counted(boundary_density_ratio(b, c, kernel, at, solid), solid.pressure[b], most);
  });
}

const float* Leftover::allow(Executor& executor, Particles& particles, double dt, int refusals,
                             float acceleration) {
  // Where nothing falls, there is no such time.
  const double fall = std::sqrt(double{support_radius_} / acceleration);
  kept_ = static_cast<float>(1 - std::min(1., dt / std::min(20 * dt, release_time * fall)));
  // Repeating a step does not ask for more than the step did.
  const double first_dt = dt * std::pow(2., refusals);
  rate_ = acceleration > 0
              ? static_cast<float>(std::clamp(first_dt / (full_rate_time * fall), least_rate, 1.))
              : 1;
  const float most = settings_.max_compression, kept = kept_,
              kept_of_dense = std::max(kept_, kept_if_too_dense);
  const float* compression = particles.compression.data();
  float* excess = particles.excess.resized(particles.count);
  executor.for_each("leftover", particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    const float c = compression[i], dense = kept_of_dense * c;
    excess[i] = dense > most ? dense : kept * c;
  });
  return excess;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
