#include "sim/pressure/leftover.hpp"

#include <algorithm>
#include <cmath>

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// Time over which compression that is left over is taken away, in units of √(H/g).
constexpr double release_time = 0.08;

/// Least share that is kept of the compression of a particle that is denser than it may be, as
/// where others reach one that walls alone had held.
constexpr float kept_if_too_dense = 0.9f;

/// Steps of this size, in units of √(H/g), and larger ones may add the whole tolerance; smaller
/// ones may add a proportional share of it, but at least the second number.
constexpr double full_rate_time = 0.04, least_rate = 0.05;

/// The compression ρ/ρ₀ − 1 that counts as left over: all of it above the rest density, and up to
/// `most` below it where pressure holds the density there. Where the density is far lower than
/// that, the pressure is what an impact left, and nothing to keep up.
SPINDRIFT_HD float counted(float density_ratio, float pressure, float most) {
  return std::max(density_ratio - 1, pressure > 0 ? -most : 0.f);
}

/// Allows particles in a nozzle the compression that comes from walls and from each other.
void allow_in_nozzles(const StepContext& s, float* excess) {
  if (s.held == nullptr)
    return;
  const CubicKernel kernel(s.constants.support_radius);
  const PointView x = s.particles.drifted_position.view();
  const float* held = s.held;
  const StepView step = s.view();
  s.executor.for_each("carry inflow", s.particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    if (held[i] > 0)
      excess[i] = std::max(0.f, carried_density_ratio(i, step.constants, kernel, x, held,
                                                      step.neighbours, step.boundary) -
                                    1.f);
  });
}

}  // namespace

void Leftover::note(const StepContext& s, const PointView& position) {
  Particles& particles = s.particles;
  const float *ratio = particles.density_ratio.data(), *pressure = particles.pressure.data(),
              *held = s.held;
  const float most = settings_.max_compression;
  float* compression = particles.compression.resized(particles.count);
  const auto note_one = [=] SPINDRIFT_HD(std::uint32_t i) {
    const bool carried = held != nullptr && held[i] > 0;
    compression[i] = carried ? 0 : counted(ratio[i], pressure[i], most);
    return Sum{std::max(0.f, compression[i])};
  };
  total_ = s.executor.reduce<Sum>("leftover", particles.count, note_one).value;
  const CubicKernel kernel(s.constants.support_radius);
  const BoundaryView solid = s.boundary;
  const PointView at = position;
  const FluidConstants c = s.constants;
  s.executor.for_each("leftover", solid.wet_count, [=] SPINDRIFT_HD(std::uint32_t k) {
    const std::uint32_t b = solid.wet[k];
    solid.compression[b] =
        counted(boundary_density_ratio(b, c, kernel, at, solid), solid.pressure[b], most);
  });
}

Allowance Leftover::allow(const StepContext& s) {
  // Without acceleration this time is infinite, and the bound of 20 steps below holds.
  const double dt = s.duration,
               fall = std::sqrt(double{s.constants.support_radius} / double{s.acceleration});
  Allowance result{.excess = s.particles.excess.resized(s.particles.count), .leftover = total_};
  result.kept = static_cast<float>(1 - std::min(1., dt / std::min(20 * dt, release_time * fall)));
  // A repeated step, which is halved each time, has the same rate as the first try.
  const double first_dt = dt * std::pow(2., s.refusals);
  if (s.acceleration > 0)
    result.rate =
        static_cast<float>(std::clamp(first_dt / (full_rate_time * fall), least_rate, 1.));
  const float most = settings_.max_compression, kept = result.kept,
              kept_of_dense = std::max(kept, kept_if_too_dense);
  const float* compression = s.particles.compression.data();
  float* excess = s.particles.excess.data();
  s.executor.for_each("leftover", s.particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    const float c = compression[i], dense = kept_of_dense * c;
    excess[i] = dense > most ? dense : kept * c;
  });
  allow_in_nozzles(s, excess);
  return result;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
