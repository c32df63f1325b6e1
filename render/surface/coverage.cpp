#include "render/surface/coverage.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "render/surface/kernel.hpp"

namespace spindrift::surface {
namespace {

// A particle of a larger coverage than this lies deeper than the outermost layer.
constexpr float enclosed = 0.85f;

// Distance from a lone particle at which the field passes the iso-value, in spacings: the radius of
// a sphere of volume 1.
constexpr float drop_radius = 0.62f;

// Kernel radius of a lone particle, in spacings, and the coverages between which the radius grows
// to the full one: from a drop of one particle (0.1) past a pair (0.16) and a thread (0.23) to the
// rim of a sheet (0.36).
constexpr float drop_kernel_radius = 1.5f;
constexpr float lone = 0.12f;
constexpr float joined = 0.3f;

// Returns the sum of kernel_shape at p over the batch, whose size is a multiple of lane_count. The
// lanes are summed in a fixed order.
// @param inverse_square 1 / (kernel radius)^2
float sum_of_kernels(const ParticleBatch& batch, const glm::vec3& p, float inverse_square) {
  Lanes sum{};
  for (std::size_t k = 0; k < batch.size(); k += lane_count<float>) {
    const Lanes dx = load_lanes(&batch.x[k]) - p.x;
    const Lanes dy = load_lanes(&batch.y[k]) - p.y;
    const Lanes dz = load_lanes(&batch.z[k]) - p.z;
    sum += kernel_shape(1.0f - (dx * dx + dy * dy + dz * dz) * inverse_square);
  }
  return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

void pad_to_lanes(ParticleBatch& batch) {
  constexpr float far_away = 1e9f;
  while (batch.size() % lane_count<float> != 0) {
    batch.x.push_back(far_away);
    batch.y.push_back(far_away);
    batch.z.push_back(far_away);
  }
}

// Returns the kernel radius of a particle of this coverage; `support` is the full radius.
float kernel_radius(float coverage, float support) {
  const float t = std::clamp((coverage - lone) / (joined - lone), 0.0f, 1.0f);
  return glm::mix(drop_kernel_radius, support, t);
}

// Returns the value that the field must have at the centre of a drop to pass the iso-value at
// drop_radius, given the kernel's radius.
float core_value(float iso_value, float radius) {
  const float t = 1.0f - drop_radius * drop_radius / (radius * radius);
  return iso_value / (t * t * t);
}

// Returns the kernel of a particle at p, and whether the particle is near a surface.
// @param around the particles within the support of p, that particle included
std::pair<ParticleKernel, bool> choose_kernel(const ParticleBatch& around, const glm::vec3& p,
                                              float support, float iso_value) {
  const float scale = kernel_scale(support);
  float sum = sum_of_kernels(around, p, 1.0f / (support * support));
  const float coverage = scale * sum;
  const float radius = kernel_radius(coverage, support);
  if (radius < support)
    sum = sum_of_kernels(around, p, 1.0f / (radius * radius));
  return {{std::max(scale, core_value(iso_value, radius) / sum), radius}, coverage < enclosed};
}

}  // namespace

Coverage measure_coverage(const ParticleBins& bins, float iso_value) {
  const float support = float(bins.bin_size());
  Coverage result;
  result.kernels.resize(bins.particle_count());
  result.enclosed.resize(bins.bin_count());
#pragma omp parallel
  {
    ParticleBatch around;
#pragma omp for schedule(dynamic, 16)
    for (std::size_t bin = 0; bin < bins.bin_count(); ++bin) {
      const glm::ivec3 cell = bins.cell(bin);
      const glm::dvec3 origin = glm::dvec3(cell) * bins.bin_size();
      around.clear();
      bins.for_each_bin(cell - 1, cell + 1, [&](std::size_t b) { bins.append(b, origin, around); });
      pad_to_lanes(around);
      bool enclosed = true;
      for (std::size_t k = bins.begin(bin); k < bins.end(bin); ++k) {
        const auto [kernel, at_surface] = choose_kernel(around, bins.local(k), support, iso_value);
        result.kernels[k] = kernel;
        enclosed = enclosed && !at_surface;
      }
      result.enclosed[bin] = enclosed;
    }
  }
  return result;
}

}  // namespace spindrift::surface
