#include "sim/boundary/boundary.hpp"

#include <algorithm>
#include <cmath>

#include "sim/boundary/domain_walls.hpp"
#include "sim/boundary/posed_body.hpp"
#include "sim/core/from_glm.hpp"
#include "sim/core/lattice.hpp"
#include "sim/core/open_faces.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// The factor by which the volumes in a wall's single layer are raised: it has no second layer
/// behind it that would stop a fluid particle which has come through between two boundary
/// particles. Measured with a cup whose walls are 0.3 spacings thick: with 1 it loses one particle
/// in a hundred in half a second; with 1.6, none of the liquid dropped into it at 3 m/s.
constexpr float single_layer_excess = 1.6f;

/// The factor that corrects the volume 1/ΣW, which is too large because one layer of boundary
/// particles has fewer neighbours than a full solid. The factor is exact for a flat layer on a
/// lattice of the liquid's spacing: there V_b = d³, and a lattice of liquid at rest on a flat wall
/// has the rest density.
float flat_layer_factor(const CubicKernel& kernel, float spacing, float radius) {
  double sum = 0;
  for_lattice_points(spacing, radius, [&](const Vec3<float>& p) {
    if (p.y == 0)
      sum += kernel.value(square_root(dot(p, p)));
  });
  return static_cast<float>(sum / lattice_kernel_sum(kernel, spacing, radius));
}

/// The share of a boundary particle's density ratio that liquid at rest on a flat wall contributes,
/// the first layer of the liquid's lattice being one spacing away.
float flat_liquid_share(const CubicKernel& kernel, float spacing, float radius) {
  double sum = 0;
  for_lattice_points(spacing, radius, [&](const Vec3<float>& p) {
    if (p.y > 0)
      sum += kernel.value(square_root(dot(p, p)));
  });
  return static_cast<float>(sum / lattice_kernel_sum(kernel, spacing, radius));
}

/// A kernel's values on a fine lattice over its support, computed once for all boundary particles.
class SupportLattice {
 public:
  SupportLattice(const CubicKernel& kernel, float radius) : cell_(2 * radius / cells_across) {
    for (int k = 0; k < cells_across; ++k)
      for (int j = 0; j < cells_across; ++j)
        for (int i = 0; i < cells_across; ++i) {
          const Vec3<float> p{(static_cast<float>(i) + 0.5f) * cell_ - radius,
                              (static_cast<float>(j) + 0.5f) * cell_ - radius,
                              (static_cast<float>(k) + 0.5f) * cell_ - radius};
          const float r = square_root(dot(p, p));
          if (r < radius)
            points_.push_back({p, kernel.value(r)});
        }
  }

  /// ∫ W over the part of the support for which `free(p)` is true, by the midpoint rule; p is
  /// relative to the boundary particle, m.
  template <class Free>
  double free_part(Free free) const {
    double sum = 0;
    for (const Point& point : points_)
      if (free(point.place))
        sum += point.value;
    return sum * cell_ * cell_ * cell_;
  }

 private:
  static constexpr int cells_across = 16;
  struct Point {
    Vec3<float> place;  ///< relative to the boundary particle, m
    float value;        ///< of the kernel, 1/m³
  };
  float cell_;  ///< step of the lattice, m
  std::vector<Point> points_;
};

void place_sentinel(PointField& field, std::uint32_t n) {
  field.view().set(n, {sentinel_position, sentinel_position, sentinel_position});
}

/// The samples of the domain's walls and of all obstacles, without those that are beyond the walls
/// and therefore never near any liquid.
std::vector<SurfaceSample> sample_all(const Settings& settings, Stop stop) {
  const float spacing = settings.fluid.spacing;
  const glm::vec3 low = settings.domain.min - spacing, high = settings.domain.max + spacing;
  std::vector<SurfaceSample> samples;
  for (const glm::vec3 p : sample_walls(settings.domain, spacing))
    samples.push_back({p, SurfaceSample::Side::domain});
  for (const Obstacle& obstacle : settings.obstacles) {
    throw_if_stopped(stop);
    if (is_apart(bounds_of(obstacle.shape), {low, high}))
      continue;
    auto more = sample_surface(obstacle.shape, spacing);
    for (SurfaceSample& sample : more)
      sample.wall_viscosity = obstacle.wall_viscosity;
    samples.insert(samples.end(), more.begin(), more.end());
  }
  std::erase_if(samples, [&](const SurfaceSample& s) {
    return glm::any(glm::lessThan(s.position, low)) || glm::any(glm::greaterThan(s.position, high));
  });
  return samples;
}

}  // namespace

Boundary::Boundary(const Settings& settings, const GridMap& map, float radius, Stop stop)
    : Boundary(settings, sample_all(settings, stop), map, radius, stop) {}

Boundary::Boundary(const Settings& settings, const std::vector<SurfaceSample>& unsorted,
                   const GridMap& map, float radius, Stop stop)
    : count_(static_cast<std::uint32_t>(unsorted.size())) {
  position_.resize(count_);
  const auto place = [&](std::uint32_t i, const SurfaceSample& s) {
    position_.view().set(i, {s.position.x, s.position.y, s.position.z});
  };
  for (std::uint32_t i = 0; i < count_; ++i)
    place(i, unsorted[i]);
  grid_.sort(map, position_.view(), count_);
  std::vector<SurfaceSample> samples;
  for (std::uint32_t i = 0; i < count_; ++i) {
    samples.push_back(unsorted[grid_.order()[i]]);
    place(i, samples[i]);
  }
  place_sentinel(position_, count_);
  grid_.forget_order();

  const CubicKernel kernel(radius);
  measure_volumes(settings, samples, map, kernel, radius, stop);
  measure_solids(settings, samples, kernel, radius, stop);
  pressure_.resize(count_);
  step_pressure_.resize(count_);
  compression_.resize(count_);
  mean_pressure_.resize(count_);
  const auto has_its_own = [](const SurfaceSample& s) { return s.wall_viscosity.has_value(); };
  if (std::any_of(samples.begin(), samples.end(), has_its_own)) {
    wall_viscosity_.resize(count_);
    for (std::uint32_t i = 0; i < count_; ++i)
      wall_viscosity_[i] = samples[i].wall_viscosity.value_or(settings.fluid.wall_viscosity);
  }
}

Boundary::Sample Boundary::sample(std::uint32_t b) const {
  const glm::vec3 p = position_.at(b);
  return {.position = {p.x, p.y, p.z},
          .volume = position_.value(b),
          .solid = solid_[b],
          .wall_viscosity = wall_viscosity_.empty() ? 0 : wall_viscosity_[b],
          .pressure = pressure_[b],
          .compression = compression_[b],
          .mean_pressure = mean_pressure_[b],
          .velocity = {0, 0, 0}};
}

void Boundary::replace(Executor& executor, const Array<Sample>& samples,
                       const Array<std::uint32_t>& chosen, const GridMap& map) {
  count_ = static_cast<std::uint32_t>(chosen.size());
  position_.resize(count_);
  velocity_.resize(count_);
  for (ScalarField* f :
       {&solid_, &pressure_, &step_pressure_, &mean_pressure_, &compression_, &wall_viscosity_})
    f->resize(count_);
  const PointView x = position_.view();
  const Vec3Arrays v = velocity_.view();
  const Sample* from = samples.data();
  const std::uint32_t* open = chosen.data();
  executor.for_each("move obstacles", count_,
                    [=] SPINDRIFT_HD(std::uint32_t i) { x.set(i, from[open[i]].position); });
  grid_.sort(map, x, count_);
  const std::uint32_t *order = grid_.order().data(), n = count_;
  float *solid = solid_.data(), *viscosity = wall_viscosity_.data(), *pressure = pressure_.data(),
        *compression = compression_.data(), *mean_pressure = mean_pressure_.data();
  executor.for_each("move obstacles", n + 1, [=] SPINDRIFT_HD(std::uint32_t i) {
    if (i == n) {
      x.set(n, {sentinel_position, sentinel_position, sentinel_position});
      return;
    }
    const Sample& s = from[open[order[i]]];
    x.set(i, s.position);
    v.set(i, s.velocity);
    x.value(i) = s.volume;
    solid[i] = s.solid;
    viscosity[i] = s.wall_viscosity;
    pressure[i] = s.pressure;
    compression[i] = s.compression;
    mean_pressure[i] = s.mean_pressure;
  });
}

/// Chooses the volumes so that liquid at rest has the rest density. Around a thick solid the
/// condition is on the density at the boundary particle itself (Akinci et al. 2012, eq. 4). On the
/// walls of the domain the volume shrinks only by as much as the particle's kernel sum exceeds that
/// over the walls alone, so that a lattice of liquid has the rest density in their edges and
/// corners too. In a thin wall the condition is on the density of the liquid's first particles, one
/// spacing away, as far as this wall contributes to it and not a wall that stands at an angle to
/// it: that counts both layers where there are two, and keeps the volumes of a single layer from
/// shrinking where walls meet.
void Boundary::measure_volumes(const Settings& settings, const std::vector<SurfaceSample>& samples,
                               const GridMap& map, const CubicKernel& kernel, float radius,
                               Stop stop) {
  const float spacing = settings.fluid.spacing;
  const glm::vec3 step = wall_lattice_step(settings.domain, spacing) / spacing;
  const float wall_volume = std::pow(step.x * step.y * step.z, 2.f / 3) /
                            static_cast<float>(lattice_kernel_sum(kernel, spacing, radius));
  ScalarField of_domain;
  of_domain.resize(count_);
  for (std::uint32_t i = 0; i < count_; ++i)
    of_domain[i] = samples[i].side == SurfaceSample::Side::domain ? 1.f : 0.f;
  const float layer = flat_layer_factor(kernel, spacing, radius);
  const float next_layer = flat_liquid_share(kernel, spacing, radius);
  NeighbourLists lists;
  lists.build(map, grid_, position_.view(), count_, grid_, position_.view(), count_, radius);
  const PointView position = position_.view();
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (i % 4096 == 0)
      throw_if_stopped(stop);
    const Vec3<float> xi = position[i];
    const auto sum_at = [&](const Vec3<float>& out) {
      const Vec3<float> x = xi + spacing * out;
      return lists.view().sum(i, [&](auto j) {
        const auto d = x - position[j], from_sample = position[j] - xi;
        const auto w = kernel.value(square_root(dot(d, d)));
        const auto height = from_sample.x * out.x + from_sample.y * out.y + from_sample.z * out.z;
        return height < 0.3f * spacing ? w : 0.f * w;
      });
    };
    const glm::vec3 n = samples[i].normal;
    switch (samples[i].side) {
      case SurfaceSample::Side::domain:
        position.value(i) = wall_volume / sum_at({0, 0, 0}) * lists.view().sum(i, [&](auto j) {
          const auto d = xi - position[j];
          return load(of_domain.data(), j) * kernel.value(square_root(dot(d, d)));
        });
        break;
      case SurfaceSample::Side::around:
        position.value(i) = layer / sum_at({0, 0, 0});
        break;
      case SurfaceSample::Side::one:
        position.value(i) = next_layer / sum_at({n.x, n.y, n.z});
        break;
      case SurfaceSample::Side::both:
        position.value(i) = single_layer_excess * next_layer /
                            std::min(sum_at({n.x, n.y, n.z}), sum_at({-n.x, -n.y, -n.z}));
    }
  }
}

/// Sets `solid` of each boundary particle to what liquid at rest around it leaves missing of the
/// density ratio 1. That liquid's contribution is the known lattice sum at a flat wall, and
/// elsewhere (edges, corners, curved obstacles) the same in proportion to the free space. For a
/// particle in one of a wall's two layers, liquid on the wall's other side does not count.
void Boundary::measure_solids(const Settings& settings, const std::vector<SurfaceSample>& samples,
                              const CubicKernel& kernel, float radius, Stop stop) {
  const float spacing = settings.fluid.spacing;
  const SupportLattice support(kernel, radius);
  const double flat = support.free_part([&](const Vec3<float>& p) { return p.y > 0.5f * spacing; });
  const double volume = 1 / lattice_kernel_sum(kernel, spacing, radius);
  const float share = flat_liquid_share(kernel, spacing, radius);
  const std::vector<Solid> solids = solids_of(settings.obstacles);
  const OpenFaces faces(settings.domain);
  const auto is_bare = [&](const Vec3<float>& p) { return faces.is_before(p, settings.domain); };
  const auto is_free = [&](const Vec3<float>& p) {
    return is_bare(p) && std::none_of(solids.begin(), solids.end(), [&](const Solid& solid) {
             return solid.contains(to_glm(p));
           });
  };
  solid_.resize(count_);
  const PointView position = position_.view();
#pragma omp parallel for schedule(dynamic, 64)
  for (std::uint32_t i = 0; i < count_; ++i) {
    if (is_stopped(stop))
      continue;
    const Vec3<float> xi = position[i];
    const SurfaceSample& sample = samples[i];
    const auto is_open = [&](const Vec3<float>& p) {
      return (sample.side != SurfaceSample::Side::one ||
              glm::dot(sample.normal, glm::vec3(p.x, p.y, p.z)) > 0) &&
             is_free(xi + p);
    };
    const double open = support.free_part(is_open);
    double lattice = 0;
    for_lattice_points(spacing, radius, [&](const Vec3<float>& p) {
      if (is_open(p))
        lattice += kernel.value(square_root(dot(p, p)));
    });
    // Along the walls of the domain liquid lies as a lattice, in edges and corners too.
    const bool at_bare_wall =
        sample.side == SurfaceSample::Side::domain &&
        (settings.obstacles.empty() ||
         open == support.free_part([&](const Vec3<float>& p) { return is_bare(xi + p); }));
    const double liquid =
        at_bare_wall ? volume * lattice : std::max(share * open / flat, volume * lattice);
    solid_[i] = 1 - static_cast<float>(liquid);
  }
  throw_if_stopped(stop);
}

std::size_t Boundary::memory_bytes() const {
  return bytes_of(position_, solid_, pressure_, step_pressure_, compression_, mean_pressure_,
                  wall_viscosity_, velocity_, grid_);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
