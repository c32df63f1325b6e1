#include "sim/moving_bodies.hpp"

#include <algorithm>
#include <cmath>

#include "sim/shapes.hpp"
#include "sim/solid.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// Samples that lie as deep as another solid's own layer count as at the same place within this
/// many spacings.
constexpr float same_layer = 1e-3f;

/// Parts of a step in which a body's way is looked at.
constexpr int parts = 4;

float deep_in(const Shape& shape, const Vec3<float>& p) {
  const Vec3<float> push = push_out(shape, p) - p;
  return square_root(dot(push, push));
}

template <class Kernel>
Vec3<float> pressure_force(std::uint32_t b, const FluidConstants& c, const Kernel& kernel,
                           const PointView& at, const BoundaryView& boundary) {
  const auto [xb, volume] = boundary.position.point(b);
  const float pb = boundary.step_pressure[b];
  const Vec3<float> sum = boundary.fluid.sum(b, [&, xb = xb](auto i) {
    const auto [xi, pi] = at.point(i);
    const auto d = xi - xb;
    return ((pi + pb) * kernel.gradient(square_root(dot(d, d)))) * d;
  });
  return (-c.volume * volume) * sum;
}

Vec3<float> friction_force(std::uint32_t b, const DiffusionKernel& kernel,
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

}  // namespace

MovingBodies::MovingBodies(const Settings& settings, const GridMap& map, Boundary& boundary)
    : settings_(settings), domain_(settings.domain), map_(map), boundary_(boundary) {
  const bool all_the_fluids = boundary.wall_viscosities() == nullptr;
  for (std::uint32_t b = 0; b < boundary.count(); ++b) {
    samples_.push_back(boundary.sample(b));
    if (all_the_fluids)
      samples_.back().wall_viscosity = settings.fluid.wall_viscosity;
  }
  owners_.assign(samples_.size(), fixed);
  placed_.resize(samples_.size());
  for (std::uint32_t b = 0; b < placed_.size(); ++b)
    placed_[b] = b;
  int body = 0;
  for (const Obstacle& obstacle : settings_.obstacles)
    if (obstacle.motion)
      add(obstacle, body++);
}

/// Samples of one body, alone in the open.
void MovingBodies::add(const Obstacle& obstacle, int body) {
  const float spacing = settings_.fluid.spacing, radius = 2 * spacing;
  Settings alone = settings_;
  alone.obstacles = {obstacle};
  const Box bounds = bounds_of(obstacle.shape);
  alone.domain = {bounds.min - 2 * radius, bounds.max + 2 * radius};
  const GridMap map = GridMap::over(from_glm(alone.domain.min), from_glm(alone.domain.max), radius);
  const Boundary samples(alone, sample_surface(obstacle.shape, spacing), map, radius);
  for (std::uint32_t b = 0; b < samples.count(); ++b) {
    samples_.push_back(samples.sample(b));
    samples_.back().wall_viscosity =
        obstacle.wall_viscosity.value_or(settings_.fluid.wall_viscosity);
    owners_.push_back(body);
  }
}

/// Whether another solid's layer of samples lies between a sample and the liquid.
bool MovingBodies::is_covered(const Vec3<float>& p, int owner) const {
  const float spacing = settings_.fluid.spacing;
  const float layer = 0.5f * spacing, margin = same_layer * spacing;
  for (int k = 0; k < static_cast<int>(bodies_.size()); ++k)
    if (k != owner && bodies_[static_cast<std::size_t>(k)].depth(p) >
                          (k > owner ? layer - margin : layer + margin))
      return true;
  if (owner == fixed)
    return false;
  if (domain_.beyond(p) > layer + margin)
    return true;
  for (const Obstacle& obstacle : settings_.obstacles)
    if (!obstacle.motion && deep_in(obstacle.shape, p) > layer + margin)
      return true;
  return false;
}

void MovingBodies::place(Executor& executor, double start, double end) {
  const PhaseClock::Scope timed(executor.clock(), "move obstacles");
  keep_pressures();
  bodies_ = posed_bodies(settings_, start, end);
  std::vector<Boundary::Sample> here = samples_;
  std::vector<char> covered(samples_.size());
#pragma omp parallel for schedule(static)
  for (std::size_t i = 0; i < here.size(); ++i) {
    if (owners_[i] != fixed) {
      const PosedBody& body = bodies_[static_cast<std::size_t>(owners_[i])];
      here[i].velocity = body.velocity(samples_[i].position);
      here[i].position = body.pose(samples_[i].position);
    }
    covered[i] = is_covered(here[i].position, owners_[i]);
  }
  std::vector<std::uint32_t> open;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < here.size(); ++i) {
    if (covered[i])
      continue;
    here[count++] = here[i];
    open.push_back(i);
  }
  here.resize(count);
  boundary_.replace(here, map_);
  placed_.clear();
  for (const std::uint32_t k : boundary_.grid().order())
    placed_.push_back(open[k]);
  share_places();
}

/// False where no solid that moves relative to the sample's own can have samples within a spacing.
bool MovingBodies::may_meet_another(std::size_t sample, const Vec3<float>& p) const {
  const float reach = 1.5f * settings_.fluid.spacing;
  const auto near = [reach](const Box& box, const Vec3<float>& q) {
    return q.x > box.min.x - reach && q.y > box.min.y - reach && q.z > box.min.z - reach &&
           q.x < box.max.x + reach && q.y < box.max.y + reach && q.z < box.max.z + reach;
  };
  for (std::size_t k = 0; k < bodies_.size(); ++k)
    if (static_cast<int>(k) != owners_[sample] && near(bodies_[k].bounds, bodies_[k].pose.back(p)))
      return true;
  if (owners_[sample] == fixed)
    return false;
  if (domain_.beyond(p) > -reach)
    return true;
  for (const Obstacle& obstacle : settings_.obstacles)
    if (!obstacle.motion && near(bounds_of(obstacle.shape), p))
      return true;
  return false;
}

void MovingBodies::share_places() {
  const CellGridView grid = boundary_.grid().view();
  const PointView x = boundary_.positions();
  const float spacing = settings_.fluid.spacing;
  RowCursors cursors(map_, grid);
  for (std::uint32_t k = 0; k < placed_.size(); ++k) {
    const Vec3<float> xk = x[k];
    if (!may_meet_another(placed_[k], xk))
      continue;
    float sharing = 0;
    for (const RowCursors::Run& run : cursors.around(map_.key(xk)))
      for (std::uint32_t j = run.begin; j < run.end; ++j) {
        const Vec3<float> away = x[j] - xk;
        if (owners_[placed_[j]] != owners_[placed_[k]])
          sharing += std::max(0.f, 1 - square_root(dot(away, away)) / spacing);
      }
    boundary_.scale_volume(k, 1 / (1 + sharing));
  }
}

double MovingBodies::step_within(double distance, double time, double longest) const {
  double step = longest;
  for (const Obstacle& obstacle : settings_.obstacles) {
    if (!obstacle.motion)
      continue;
    // A turn to and fro must not look like rest.
    for (const Oscillation& o : obstacle.motion->oscillations)
      step = std::min(step, 0.25 / std::max(1e-9, std::abs(double{o.frequency})));
    if (obstacle.motion->spin)
      step =
          std::min(step, 0.25 / std::max(1e-9, std::abs(double{obstacle.motion->spin->frequency})));
    const Box bounds = bounds_of(obstacle.shape);
    const Pose before = pose_at(obstacle, time);
    // Each coordinate of the way is linear in the place, so that the corners go farthest.
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

void MovingBodies::keep_pressures() {
  std::vector<bool> present(samples_.size(), false);
  for (std::uint32_t k = 0; k < placed_.size(); ++k) {
    samples_[placed_[k]].pressure = boundary_.pressures()[k];
    samples_[placed_[k]].compression = boundary_.compressions()[k];
    samples_[placed_[k]].mean_pressure = boundary_.mean_pressures()[k];
    present[placed_[k]] = true;
  }
  for (std::size_t i = 0; i < samples_.size(); ++i)
    if (!present[i])
      samples_[i].pressure = samples_[i].mean_pressure = samples_[i].compression = 0;
}

std::vector<float> MovingBodies::pressures() const {
  std::vector<float> values(samples_.size(), 0.f);
  for (std::uint32_t k = 0; k < placed_.size(); ++k)
    values[placed_[k]] = boundary_.pressures()[k];
  return values;
}

void MovingBodies::set_pressures(const std::vector<float>& pressures) {
  for (std::uint32_t k = 0; k < placed_.size(); ++k)
    boundary_.pressures()[k] = pressures[placed_[k]];
}

std::size_t MovingBodies::memory_bytes() const {
  return samples_.capacity() * sizeof(Boundary::Sample) + owners_.capacity() * sizeof(int) +
         placed_.capacity() * sizeof(std::uint32_t);
}

double wall_work(Executor& executor, const FluidConstants& constants, PressureKernel kernel,
                 Particles& particles, const BoundaryView& boundary, float time_step) {
  const CubicKernel cubic(constants.support_radius);
  const SpikyKernel spiky(constants.support_radius);
  const DiffusionKernel diffusion(constants.spacing, constants.support_radius);
  const PointView x = particles.drifted_position.view(), v = particles.drifted_velocity.view();
  return executor
      .reduce_on_host<Sum>("wall work", boundary.wet_count,
                           [&](std::uint32_t k) {
                             const std::uint32_t b = boundary.wet[k];
                             const Vec3<float> way = time_step * boundary.velocity[b];
                             if (dot(way, way) == 0)
                               return Sum{};
                             Vec3<float> force =
                                 kernel == PressureKernel::spiky
                                     ? pressure_force(b, constants, spiky, x, boundary)
                                     : pressure_force(b, constants, cubic, x, boundary);
                             if (boundary.wall_viscosity[b] > 0)
                               force += friction_force(b, diffusion, x, v, boundary);
                             return Sum{double{dot(force, way)}};
                           })
      .value;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
