#include "render/surface/surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "render/surface/coverage.hpp"
#include "render/surface/marching_cubes.hpp"
#include "render/surface/particle_bins.hpp"
#include "render/surface/smoothing.hpp"
#include "render/surface/sparse_field.hpp"

namespace spindrift::surface {
namespace {

// Throws for a value out of range; the comparison is written so that NaN fails it.
template <typename Number>
void require_within(const char* name, Number value, Number lowest, Number highest) {
  if (!(value >= lowest && value <= highest))
    throw std::invalid_argument(
        fmt::format("surface {} is {}; it must lie in {} ... {}", name, value, lowest, highest));
}

void validate(float spacing, const SurfaceSettings& settings) {
  if (!(spacing > 0.0f) || !std::isfinite(spacing))
    throw std::invalid_argument(
        fmt::format("particle spacing is {} m; it must be positive and finite", spacing));
  require_within("cell_size", settings.cell_size, 0.1f, 1.0f);
  require_within("kernel_radius", settings.kernel_radius, 1.5f, 4.0f);
  require_within("iso_value", settings.iso_value, 0.2f, 0.8f);
  require_within("smoothing", settings.smoothing, 0, 100);
}

}  // namespace

Mesh reconstruct_surface(std::span<const glm::vec3> positions, float spacing,
                         const SurfaceSettings& settings) {
  validate(spacing, settings);
  constexpr double farthest = 1 << 20;  // in cells or spacings: as far as float vertices resolve
  const double cell_size = double(settings.cell_size);
  const ParticleBins bins(positions, spacing, double(settings.kernel_radius),
                          farthest * std::min(1.0, cell_size));
  const Coverage coverage = measure_coverage(bins, settings.iso_value);
  const SparseField field(bins, coverage, cell_size, settings.iso_value);
  IsoSurface surface = march_cubes(field, settings.iso_value, spacing);
  smooth_mesh(surface.mesh, surface.bulk, settings.smoothing);
  return std::move(surface.mesh);
}

}  // namespace spindrift::surface
