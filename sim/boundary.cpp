#include "sim/boundary.hpp"

#include <algorithm>
#include <cmath>

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
  const std::size_t wall_count = samples.size();
  for (const Obstacle& obstacle : settings.obstacles) {
    const auto more = sample_surface(obstacle.shape, spacing);
    samples.insert(samples.end(), more.begin(), more.end());
  }
  // Samples of obstacles beyond the walls are never near any liquid.
  const glm::vec3 low = settings.domain.min - spacing, high = settings.domain.max + spacing;
  samples.erase(std::remove_if(
                    samples.begin() + static_cast<std::ptrdiff_t>(wall_count), samples.end(),
                    [&](glm::vec3 p) {
                      return glm::any(glm::lessThan(p, low)) || glm::any(glm::greaterThan(p, high));
                    }),
                samples.end());
  count_ = static_cast<std::uint32_t>(samples.size());

  VectorField unsorted;
  unsorted.resize(count_);
  for (std::uint32_t i = 0; i < count_; ++i)
    unsorted.view().set(i, {samples[i].x, samples[i].y, samples[i].z});
  grid_.sort(map, unsorted.view(), count_);

  position_.resize(count_);
  for (std::uint32_t i = 0; i < count_; ++i)
    position_.view().set(i, unsorted.view()[grid_.order()[i]]);
  place_sentinel(position_, count_);

  const CubicKernel kernel(radius);
  measure_volumes(settings, map, kernel, wall_count);
  measure_solids(settings, kernel, wall_count);
  pressure_.resize(count_);
  step_pressure_.resize(count_);
}

/// V_b = 1/ΣW (Akinci et al. 2012, eq. 4) times a factor that makes it right for a flat layer. On
/// the walls of the domain, whose samples form a lattice that is bent at the edges, ΣW over the
/// wall itself cancels out, so that a lattice of liquid has the rest density in edges and corners
/// too.
void Boundary::measure_volumes(const Settings& settings, const GridMap& map,
                               const CubicKernel& kernel, std::size_t wall_count) {
  const float radius = 1 / kernel.inverse_radius;
  const float spacing = settings.fluid.spacing;
  const float factor = flat_layer_factor(kernel, spacing, radius);
  const auto lattice = static_cast<float>(1 / lattice_kernel_sum(kernel, spacing, radius));
  const glm::vec3 step = wall_lattice_step(settings.domain, spacing) / spacing;
  const float wall_volume = lattice * std::pow(step.x * step.y * step.z, 2.f / 3);
  NeighbourLists lists;
  lists.build(map, grid_, position_.view(), count_, grid_, position_.view(), count_, radius);
  const NeighbourView view = lists.view();
  const Vec3Arrays position = position_.view();
  volume_.resize(count_);
  for (std::uint32_t i = 0; i < count_; ++i) {
    const Vec3<float> xi = position[i];
    const std::uint32_t* j = view.first[i];
    float all = 0, own = 0;
    for (std::uint32_t left = view.batches[i] * lane_count; left > 0; --left, ++j) {
      const Vec3<float> d = xi - position[*j];
      const float w = kernel.value(square_root(dot(d, d)));
      all += w;
      own += *j < count_ && grid_.order()[*j] < wall_count ? w : 0.f;
    }
    volume_[i] = grid_.order()[i] < wall_count ? wall_volume * own / all : factor / all;
  }
}

/// A sample's solid makes up for what the liquid does not when it is at rest around it: at a flat
/// wall the known lattice sum, elsewhere (edges, corners, curved obstacles) that in proportion to
/// the free space.
void Boundary::measure_solids(const Settings& settings, const CubicKernel& kernel,
                              std::size_t wall_count) {
  const float radius = 1 / kernel.inverse_radius;
  const float spacing = settings.fluid.spacing;
  const double flat =
      free_part(kernel, radius, [&](const Vec3<float>& p) { return p.y > 0.5f * spacing; });
  const double volume = 1 / lattice_kernel_sum(kernel, spacing, radius);
  const float share = flat_liquid_share(kernel, spacing, radius);
  const ContactView contact{{settings.domain.min.x, settings.domain.min.y, settings.domain.min.z},
                            {settings.domain.max.x, settings.domain.max.y, settings.domain.max.z},
                            settings.obstacles.data(),
                            settings.obstacles.size()};
  const ContactView walls{contact.min, contact.max, nullptr, 0};
  solid_.resize(count_);
  const Vec3Arrays position = position_.view();
#pragma omp parallel for schedule(dynamic, 64)
  for (std::uint32_t i = 0; i < count_; ++i) {
    const Vec3<float> xi = position[i];
    const auto is_free = [&](const Vec3<float>& p) {
      const Vec3<float> moved = contact.resolve(xi + p) - (xi + p);
      return dot(moved, moved) == 0;
    };
    double lattice = 0;
    for_lattice_points(spacing, radius, [&](const Vec3<float>& p) {
      if (is_free(p))
        lattice += kernel.value(square_root(dot(p, p)));
    });
    const double open = free_part(kernel, radius, is_free);
    // Liquid lies as a lattice along the walls of the domain, edges and corners included.
    const bool at_bare_wall =
        grid_.order()[i] < wall_count &&
        (settings.obstacles.empty() || open == free_part(kernel, radius, [&](const Vec3<float>& p) {
                                         const Vec3<float> moved = walls.resolve(xi + p) - (xi + p);
                                         return dot(moved, moved) == 0;
                                       }));
    const double liquid =
        at_bare_wall ? volume * lattice : std::max(share * open / flat, volume * lattice);
    solid_[i] = 1 - static_cast<float>(liquid);
  }
}

std::size_t Boundary::memory_bytes() const {
  return position_.memory_bytes() + 4 * volume_.memory_bytes() + grid_.memory_bytes();
}

}  // namespace spindrift::sim
