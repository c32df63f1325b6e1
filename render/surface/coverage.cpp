#include "render/surface/coverage.hpp"

#include <array>

namespace spindrift::surface {
namespace {

// Coverage above which a particle lies deeper than the outermost layer.
constexpr float kEnclosed = 0.85f;

// Volumes are raised until a particle's own field value is this many times the iso-value. A drop of
// volume d^3 needs 1.21 and a sheet of thickness d needs 1.25, at a support of 2.5 d.
constexpr float kCoreOverIso = 1.24f;

constexpr std::size_t kLanes = 8;

// Sum of (1 - |p - q|^2 / h^2)^3 over the batch, whose size is a multiple of kLanes. The lanes are
// summed in a fixed order.
float sum_of_kernels(const ParticleBatch& batch, const glm::vec3& p, float inverse_square) {
  const float* const x = batch.x.data();
  const float* const y = batch.y.data();
  const float* const z = batch.z.data();
  std::array<float, kLanes> sum{};
  for (std::size_t k = 0; k < batch.size(); k += kLanes) {
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const float dx = x[k + lane] - p.x;
      const float dy = y[k + lane] - p.y;
      const float dz = z[k + lane] - p.z;
      const float t = 1.0f - (dx * dx + dy * dy + dz * dz) * inverse_square;
      const float inside = t > 0.0f ? t : 0.0f;
      sum[lane] += inside * inside * inside;
    }
  }
  return ((sum[0] + sum[4]) + (sum[2] + sum[6])) + ((sum[1] + sum[5]) + (sum[3] + sum[7]));
}

void pad_to_lanes(ParticleBatch& batch) {
  constexpr float far_away = 1e9f;
  while (batch.size() % kLanes != 0) {
    batch.x.push_back(far_away);
    batch.y.push_back(far_away);
    batch.z.push_back(far_away);
  }
}

}  // namespace

Coverage measure_coverage(const ParticleBins& bins, float iso_value) {
  const float support = float(bins.bin_size());
  const float inverse_square = 1.0f / (support * support);
  const float peak = kernel_peak(support);
  const float core = kCoreOverIso * iso_value;

  Coverage result;
  result.volume.resize(bins.particle_count());
  result.enclosed.resize(bins.bin_count());
#pragma omp parallel
  {
    ParticleBatch batch;
#pragma omp for schedule(dynamic, 16)
    for (std::size_t bin = 0; bin < bins.bin_count(); ++bin) {
      const glm::ivec3 cell = bins.cell(bin);
      const glm::dvec3 origin = glm::dvec3(cell) * bins.bin_size();
      batch.clear();
      bins.for_each_bin(cell - 1, cell + 1,
                        [&](std::size_t b) { bins.append(b, origin, {}, batch); });
      pad_to_lanes(batch);
      bool enclosed = true;
      for (std::size_t k = bins.begin(bin); k < bins.end(bin); ++k) {
        const float coverage = peak * sum_of_kernels(batch, bins.local(k), inverse_square);
        result.volume[k] = std::max(1.0f, core / coverage);
        enclosed = enclosed && coverage >= kEnclosed;
      }
      result.enclosed[bin] = enclosed;
    }
  }
  return result;
}

}  // namespace spindrift::surface
