#include "sim/boundary/moving_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "sim/boundary/obstacle_motion.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// The tolerance, in spacings, within which a boundary particle counts as lying at the depth of
/// another solid's own layer.
constexpr float same_layer = 1e-3f;

/// The number of instants within a step at which the displacement of a body is checked.
constexpr int parts = 4;

/// The depth of a point below the surface of a solid, m; 0 outside.
SPINDRIFT_HD float deep_in(const Solid& solid, const Vec3<float>& p) {
  const Vec3<float> push = push_out_of(solid, p) - p;
  return square_root(dot(push, push));
}

/// Whether a point is in a box that is enlarged by `reach` (m) on all sides.
SPINDRIFT_HD bool is_near(const Box& box, const Vec3<float>& p, float reach) {
  return p.x > box.min.x - reach && p.y > box.min.y - reach && p.z > box.min.z - reach &&
         p.x < box.max.x + reach && p.y < box.max.y + reach && p.z < box.max.z + reach;
}

/// The force by pressure of boundary particle b on the liquid, N.
template <class Kernel>
SPINDRIFT_HD Vec3<float> pressure_force(std::uint32_t b, const FluidConstants& c,
                                        const Kernel& kernel, const PointView& at,
                                        const BoundaryView& boundary) {
  const auto [xb, volume] = boundary.position.point(b);
  const float pb = boundary.step_pressure[b];
  const Vec3<float> sum = boundary.fluid.sum(b, [&, xb = xb](auto i) {
    const auto [xi, pi] = at.point(i);
    const auto d = xi - xb;
    return ((pi + pb) * kernel.gradient(square_root(dot(d, d)))) * d;
  });
  return (-c.volume * volume) * sum;
}

/// The force by wall friction of boundary particle b on the liquid, N.
SPINDRIFT_HD Vec3<float> friction_force(std::uint32_t b, const DiffusionKernel& kernel,
                                        const PointView& position, const PointView& velocity,
                                        const BoundaryView& boundary) {
  const auto [xb, volume] = boundary.position.point(b);
  const Vec3<float> vb = boundary.velocity[b];
  const Vec3<float> sum = boundary.fluid.sum(b, [&, xb = xb](auto i) {
    const auto d = position[i] - xb;
    return kernel.weight(dot(d, d)) * (vb - velocity[i]);
  });
  return (2 * boundary.wall_viscosity[b] * volume) * sum;
}

/// Copies what the boundary particles carry from step to step back into the samples; those that are
/// left out carry nothing.
/// @param placed for each boundary particle, which of the samples it is
void keep_pressures(Executor& executor, Boundary& boundary, const std::uint32_t* placed,
                    Array<Boundary::Sample>& all_samples) {
  Boundary::Sample* samples = all_samples.data();
  executor.for_each("move obstacles", static_cast<std::uint32_t>(all_samples.size()),
                    [=] SPINDRIFT_HD(std::uint32_t i) {
                      Boundary::Sample& s = samples[i];
                      s.pressure = s.mean_pressure = s.compression = 0;
                    });
  const float *pressure = boundary.pressures().data(),
              *compression = boundary.compressions().data(),
              *mean_pressure = boundary.mean_pressures().data();
  executor.for_each("move obstacles", boundary.count(), [=] SPINDRIFT_HD(std::uint32_t k) {
    Boundary::Sample& s = samples[placed[k]];
    s.pressure = pressure[k];
    s.compression = compression[k];
    s.mean_pressure = mean_pressure[k];
  });
}

/// Lessens the volumes of boundary particles where the layers of two solids meet at an angle.
/// @param placed for each boundary particle, which of the samples it is
/// @param owners of the samples
void share_places(Executor& executor, Boundary& boundary, const GridMap& cells,
                  const std::uint32_t* placed, const int* owners, const SolidsView& all) {
  const CellGridView grid = boundary.grid().view();
  const PointView x = boundary.positions();
  const GridMap map = cells;
  const SolidsView solids = all;
  executor.for_each("move obstacles", boundary.count(), [=] SPINDRIFT_HD(std::uint32_t k) {
    const Vec3<float> xk = x[k];
    const int owner = owners[placed[k]];
    if (!solids.may_meet_another(xk, owner))
      return;
    float sharing = 0;
    for (int row = 0; row < 9; ++row) {
      const std::uint64_t low = map.row_key(map.key(xk), row);
      for (std::uint32_t c = grid.first_cell_from(low);
           c < grid.cell_count && grid.cell_key(c) <= low + 2; ++c)
        for (std::uint32_t j = grid.cell_begin(c); j < grid.cell_begin(c + 1); ++j) {
          const Vec3<float> away = x[j] - xk;
          if (owners[placed[j]] != owner)
            sharing += std::max(0.f, 1 - square_root(dot(away, away)) / solids.spacing);
        }
    }
    x.value(k) *= 1 / (1 + sharing);
  });
}

}  // namespace

MovingBodies::MovingBodies(const Settings& settings, const GridMap& map, Boundary& boundary,
                           Meshes& meshes, Stop stop)
    : settings_(settings),
      map_(map),
      boundary_(boundary),
      all_solids_(solids_of(settings.obstacles, meshes)) {
  const bool all_the_fluids = boundary.wall_viscosities() == nullptr;
  std::vector<Boundary::Sample> samples;
  for (std::uint32_t b = 0; b < boundary.count(); ++b) {
    samples.push_back(boundary.sample(b));
    if (all_the_fluids)
      samples.back().wall_viscosity = settings.fluid.wall_viscosity;
  }
  std::vector<std::uint32_t> placed(samples.size());
  for (std::uint32_t b = 0; b < placed.size(); ++b)
    placed[b] = b;
  put(placed_, placed);
  std::vector<int> owners(samples.size(), fixed);
  std::vector<Solid> solids;
  std::vector<Box> bounds;
  int body = 0;
  for (std::size_t k = 0; k < all_solids_.size(); ++k) {
    const Obstacle& obstacle = settings_.obstacles[k];
    if (obstacle.motion) {
      add(obstacle, body++, samples, owners, stop);
    } else {
      solids.push_back(all_solids_[k]);
      bounds.push_back(bounds_of(obstacle.shape));
    }
  }
  put(samples_, samples);
  put(owners_, owners);
  put(fixed_solids_, solids);
  put(fixed_bounds_, bounds);
}

/// Appends the boundary particles of one body, with the volumes and `solid` that they have when the
/// body is alone in the open.
void MovingBodies::add(const Obstacle& obstacle, int body, std::vector<Boundary::Sample>& all,
                       std::vector<int>& owners, Stop stop) const {
  const float spacing = settings_.fluid.spacing, radius = 2 * spacing;
  Settings alone = settings_;
  alone.obstacles = {obstacle};
  const Box bounds = bounds_of(obstacle.shape);
  alone.domain = {bounds.min - 2 * radius, bounds.max + 2 * radius};
  const GridMap map = GridMap::over(from_glm(alone.domain.min), from_glm(alone.domain.max), radius);
  const Boundary samples(alone, sample_surface(obstacle.shape, spacing), map, radius, stop);
  for (std::uint32_t b = 0; b < samples.count(); ++b) {
    all.push_back(samples.sample(b));
    all.back().wall_viscosity = obstacle.wall_viscosity.value_or(settings_.fluid.wall_viscosity);
    owners.push_back(body);
  }
}

bool SolidsView::is_covered(const Vec3<float>& p, int owner) const {
  const float layer = 0.5f * spacing, margin = same_layer * spacing;
  for (int k = 0; k < body_count; ++k)
    if (k != owner && bodies[k].depth(p) > (k > owner ? layer - margin : layer + margin))
      return true;
  if (owner == fixed)
    return false;
  if (domain.beyond(p) > layer + margin)
    return true;
  for (int k = 0; k < solid_count; ++k)
    if (deep_in(solids[k], p) > layer + margin)
      return true;
  return false;
}

bool SolidsView::may_meet_another(const Vec3<float>& p, int owner) const {
  const float reach = 1.5f * spacing;
  for (int k = 0; k < body_count; ++k)
    if (k != owner && is_near(bodies[k].bounds, bodies[k].pose.back(p), reach))
      return true;
  if (owner == fixed)
    return false;
  if (domain.beyond(p) > -reach)
    return true;
  for (int k = 0; k < solid_count; ++k)
    if (is_near(bounds[k], p, reach))
      return true;
  return false;
}

void MovingBodies::place(Executor& executor, double start, double end) {
  keep_pressures(executor, boundary_, placed_.data(), samples_);
  put(bodies_, posed_bodies(settings_, all_solids_, start, end));
  const auto n = static_cast<std::uint32_t>(samples_.size());
  const SolidsView solids{
      bodies_.data(),         static_cast<int>(bodies_.size()),       fixed_solids_.data(),
      fixed_bounds_.data(),   static_cast<int>(fixed_solids_.size()), Inside(settings_.domain),
      settings_.fluid.spacing};
  grow(here_, n);
  grow(covered_, n);
  const Boundary::Sample* samples = samples_.data();
  Boundary::Sample* here = here_.data();
  const int* owners = owners_.data();
  std::uint8_t* covered = covered_.data();
  executor.for_each("move obstacles", n, [=] SPINDRIFT_HD(std::uint32_t i) {
    Boundary::Sample sample = samples[i];
    const int owner = owners[i];
    if (owner != SolidsView::fixed) {
      const PosedBody& body = solids.bodies[owner];
      sample.velocity = body.velocity(samples[i].position);
      sample.position = body.pose(samples[i].position);
    }
    here[i] = sample;
    covered[i] = solids.is_covered(sample.position, owner);
  });
  executor.select("move obstacles", n, open_,
                  [=] SPINDRIFT_HD(std::uint32_t i) { return covered[i] == 0; });
  boundary_.replace(executor, here_, open_, map_);
  const auto count = static_cast<std::uint32_t>(open_.size());
  grow(placed_, count);
  const std::uint32_t *order = boundary_.grid().order().data(), *open = open_.data();
  std::uint32_t* placed = placed_.data();
  executor.for_each("move obstacles", count,
                    [=] SPINDRIFT_HD(std::uint32_t k) { placed[k] = open[order[k]]; });
  share_places(executor, boundary_, map_, placed, owners, solids);
}

double MovingBodies::step_within(double distance, double time, double longest) const {
  double step = longest;
  for (const Obstacle& obstacle : settings_.obstacles) {
    if (!obstacle.motion)
      continue;
    // At most a quarter of a period: a swing to and fro within a step would look like rest.
    for (const Oscillation& o : obstacle.motion->oscillations)
      step = std::min(step, 0.25 / std::max(1e-9, std::abs(double{o.frequency})));
    if (obstacle.motion->spin)
      step =
          std::min(step, 0.25 / std::max(1e-9, std::abs(double{obstacle.motion->spin->frequency})));
    const Box bounds = bounds_of(obstacle.shape);
    const Pose before = pose_at(obstacle, time);
    // Each coordinate of the displacement is linear in the position, so the corners move farthest.
    const auto farthest = [&](double after) {
      const Pose pose = pose_at(obstacle, time + after);
      double way = 0;
      for (int corner = 0; corner < 8; ++corner) {
        const glm::dvec3 p((corner & 1) ? bounds.max.x : bounds.min.x,
                           (corner & 2) ? bounds.max.y : bounds.min.y,
                           (corner & 4) ? bounds.max.z : bounds.min.z);
        way = std::max(way, glm::distance(pose(p), before(p)));
      }
      return way;
    };
    const auto too_far = [&] {
      for (int k = 1; k <= parts; ++k)
        if (farthest(step * k / parts) > distance)
          return true;
      return false;
    };
    const double least = settings_.solver.min_time_step;
    while (step > least && too_far())
      step *= 0.8;
  }
  return step;
}

Copy<float> MovingBodies::pressures(Executor& executor) {
  keep_pressures(executor, boundary_, placed_.data(), samples_);
  const Boundary::Sample* samples = samples_.data();
  return executor.copy<float>("take frame", static_cast<std::uint32_t>(samples_.size()),
                              [=] SPINDRIFT_HD(std::uint32_t i) { return samples[i].pressure; });
}

void MovingBodies::set_pressures(const std::vector<float>& pressures) {
  for (std::uint32_t k = 0; k < placed_.size(); ++k)
    boundary_.pressures()[k] = pressures[placed_[k]];
}

std::size_t MovingBodies::memory_bytes() const {
  return bytes_of(all_solids_, fixed_solids_, fixed_bounds_, bodies_, samples_, here_, owners_,
                  covered_, open_, placed_);
}

double wall_work(Executor& executor, const FluidConstants& constants, PressureKernel kernel,
                 Particles& particles, const BoundaryView& boundary, float time_step) {
  const CubicKernel cubic(constants.support_radius);
  const SpikyKernel spiky(constants.support_radius);
  const DiffusionKernel diffusion(constants.spacing, constants.support_radius);
  const PointView x = particles.drifted_position.view(), v = particles.drifted_velocity.view();
  const BoundaryView solid = boundary;
  const FluidConstants c = constants;
  const auto work = [=] SPINDRIFT_HD(std::uint32_t k) {
    const std::uint32_t b = solid.wet[k];
    const Vec3<float> way = time_step * solid.velocity[b];
    if (dot(way, way) == 0)
      return Sum{};
    Vec3<float> force = kernel == PressureKernel::spiky ? pressure_force(b, c, spiky, x, solid)
                                                        : pressure_force(b, c, cubic, x, solid);
    if (solid.wall_viscosity[b] > 0)
      force += friction_force(b, diffusion, x, v, solid);
    return Sum{double{dot(force, way)}};
  };
  return executor.reduce<Sum>("wall work", solid.wet_count, work).value;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
