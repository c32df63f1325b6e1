#include "sim/boundary.hpp"

#include <algorithm>

#include "sim/contact.hpp"
#include "sim/lattice.hpp"
#include "sim/shapes.hpp"

namespace spindrift::sim {
namespace {

/// One layer of samples has fewer neighbours than a full solid, so that 1/ΣW is too large a volume.
/// This factor makes it right for a flat layer on a lattice of the liquid's spacing: there V_b = d³
/// exactly, and a lattice of liquid at rest on a flat wall has the rest density.
float flat_layer_factor(const CubicKernel& kernel, float spacing, float radius) {
  double sum = 0;
  for_lattice_points(spacing, radius, [&](const Vec3<float>& p) {
    if (p.y == 0)
      sum += kernel.value(square_root(dot(p, p)));
  });
  return static_cast<float>(sum / lattice_kernel_sum(kernel, spacing, radius));
}

/// Share of a sample's density ratio that liquid at rest on a flat wall contributes, the lattice's
/// first layer being one spacing away.
float flat_liquid_share(const CubicKernel& kernel, float spacing, float radius) {
  double sum = 0;
  for_lattice_points(spacing, radius, [&](const Vec3<float>& p) {
    if (p.y > 0)
      sum += kernel.value(square_root(dot(p, p)));
  });
  return static_cast<float>(sum / lattice_kernel_sum(kernel, spacing, radius));
}

/// ∫ W over the part of a sample's support for which `free` holds, by the midpoint rule on a fine
/// lattice.
template <class Free>
double free_part(const CubicKernel& kernel, float radius, Free free) {
  constexpr int cells_across = 16;
  const float h = 2 * radius / cells_across;
  double sum = 0;
  for (int k = 0; k < cells_across; ++k)
    for (int j = 0; j < cells_across; ++j)
      for (int i = 0; i < cells_across; ++i) {
        const Vec3<float> p{(static_cast<float>(i) + 0.5f) * h - radius,
                            (static_cast<float>(j) + 0.5f) * h - radius,
                            (static_cast<float>(k) + 0.5f) * h - radius};
        const float r = square_root(dot(p, p));
        if (r < radius && free(p))
          sum += kernel.value(r);
      }
  return sum * h * h * h;
}

void place_sentinel(VectorField& field, std::uint32_t n) {
  field.view().set(n, {sentinel_position, sentinel_position, sentinel_position});
}

}  // namespace

Boundary::Boundary(const Settings& settings, const GridMap& map, float radius) {
  const float spacing = settings.fluid.spacing;
  std::vector<glm::vec3> samples = sample_walls(settings.domain, spacing);
  for (const Obstacle& obstacle : settings.obstacles) {
    const auto more = sample_surface(obstacle.shape, spacing);
    samples.insert(samples.end(), more.begin(), more.end());
  }
  // Samples of obstacles beyond the walls are never near any liquid.
  const glm::vec3 low = settings.domain.min - spacing, high = settings.domain.max + spacing;
  std::erase_if(samples, [&](glm::vec3 p) {
    return glm::any(glm::lessThan(p, low)) || glm::any(glm::greaterThan(p, high));
  });
  count_ = static_cast<std::uint32_t>(samples.size());

  VectorField unsorted;
  unsorted.resize(count_);
  for (std::uint32_t i = 0; i < count_; ++i)
    unsorted.view().set(i, {samples[i].x, samples[i].y, samples[i].z});
  grid_.sort(map, unsorted.view(), count_);

  position_.resize(count_);
  volume_.resize(count_);
  for (std::uint32_t i = 0; i < count_; ++i)
    position_.view().set(i, unsorted.view()[grid_.order()[i]]);
  place_sentinel(position_, count_);

  const CubicKernel kernel(radius);
  const float factor = flat_layer_factor(kernel, spacing, radius);
  NeighbourLists lists;
  lists.build(map, grid_, position_.view(), count_, grid_, position_.view(), count_, radius);
  const Vec3Arrays position = position_.view();
  for (std::uint32_t i = 0; i < count_; ++i) {
    const Vec3<float> xi = position[i];
    const float sum = lists.view().sum(i, [&](auto j) {
      const auto d = xi - position[j];
      return kernel.value(square_root(dot(d, d)));
    });
    volume_[i] = factor / sum;
  }
  measure_solids(settings, kernel, radius);
  pressure_.resize(count_);
  step_pressure_.resize(count_);
}

/// A sample's solid makes up for what the liquid does not when it is at rest around it: at a flat
/// wall the known lattice sum, elsewhere (edges, corners, curved obstacles) that in proportion to
/// the free space.
void Boundary::measure_solids(const Settings& settings, const CubicKernel& kernel, float radius) {
  const float spacing = settings.fluid.spacing;
  const double flat =
      free_part(kernel, radius, [&](const Vec3<float>& p) { return p.y > 0.5f * spacing; });
  const double volume = 1 / lattice_kernel_sum(kernel, spacing, radius);
  const float share = flat_liquid_share(kernel, spacing, radius);
  const ContactView contact{{settings.domain.min.x, settings.domain.min.y, settings.domain.min.z},
                            {settings.domain.max.x, settings.domain.max.y, settings.domain.max.z},
                            settings.obstacles.data(),
                            settings.obstacles.size()};
  solid_.resize(count_);
  const Vec3Arrays position = position_.view();
#pragma omp parallel for schedule(dynamic, 64)
  for (std::uint32_t i = 0; i < count_; ++i) {
    const Vec3<float> xi = position[i];
    const double open = free_part(kernel, radius, [&](const Vec3<float>& p) {
      const Vec3<float> moved = contact.resolve(xi + p) - (xi + p);
      return dot(moved, moved) == 0;
    });
    double lattice = 0;
    for_lattice_points(spacing, radius, [&](const Vec3<float>& p) {
      const Vec3<float> moved = contact.resolve(xi + p) - (xi + p);
      if (dot(moved, moved) == 0)
        lattice += kernel.value(square_root(dot(p, p)));
    });
    solid_[i] = 1 - static_cast<float>(std::max(share * open / flat, volume * lattice));
  }
}

std::size_t Boundary::memory_bytes() const {
  return position_.memory_bytes() + 4 * volume_.memory_bytes() + grid_.memory_bytes();
}

}  // namespace spindrift::sim
