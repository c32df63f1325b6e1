#include "sim/start/initial.hpp"

#include <algorithm>
#include <cmath>

#include "sim/backend/cells.hpp"
#include "sim/backend/point_cells.hpp"
#include "sim/boundary/domain_walls.hpp"
#include "sim/boundary/obstacle_motion.hpp"
#include "sim/core/fluid_constants.hpp"
#include "sim/core/from_glm.hpp"
#include "sim/core/kernels.hpp"
#include "sim/core/lattice.hpp"
#include "sim/flow/nozzle.hpp"
#include "sim/flow/outflow.hpp"
#include "sim/start/fill.hpp"
#include "sim/start/packing.hpp"

namespace spindrift::sim {

namespace {

/// The distance, in spacings, from a cell that a body cuts within which particles are packed.
constexpr float packed_reach = 3;

/// A number in [0, 1) for each cell of a lattice, such that the numbers are spread evenly in every
/// part of the lattice (Roberts 2018, the R₃ sequence).
/// @param place the cell's indices
double even_number(const glm::vec3& place) {
  const glm::dvec3 sum = glm::dvec3(place) * glm::dvec3(0.8191725134, 0.6710436067, 0.5497004779);
  const double one = sum.x + sum.y + sum.z + 0.5;
  return one - std::floor(one);
}

bool is_outside(const DomainSettings& domain, const glm::vec3& p) {
  return glm::any(glm::lessThan(p, domain.min)) || glm::any(glm::greaterThan(p, domain.max));
}

/// Whether particles are made, or only counted.
enum class Wanted { particles, counts };

/// Fills volumes with particles, one after the other.
class Filling {
 public:
  Filling(const Settings& settings, Wanted wanted, Stop stop)
      : settings_(settings),
        wanted_(wanted),
        stop_(stop),
        bodies_(settings),
        edge_(particle_spacing(settings)) {}

  void add(const Volume& volume) {
    const Shape inside = within_domain(volume.shape, settings_.domain);
    const FilledShape filled = fill_shape(inside, settings_.fluid.spacing, edge_, stop_);
    FilledVolume result;
    for (const glm::vec3& p : filled.points)
      place(p, filled.step, inside, result);
    initial_.velocities.resize(initial_.positions.size(), volume.velocity);
    initial_.volumes.push_back(result);
  }

  const std::vector<FilledVolume>& counts() const { return initial_.volumes; }

  InitialParticles take() {
    if (!cut_.empty() && !initial_.positions.empty())
      pack_near_cuts();
    return std::move(initial_);
  }

 private:
  /// Places the particle of a lattice's cell, or leaves it out: of the cells that a body cuts, as
  /// many get a particle as the free parts of these cells make up together.
  void place(const glm::vec3& p, const glm::vec3& step, const Shape& shape, FilledVolume& result) {
    if (++looked_at_ % 4096 == 0)
      throw_if_stopped(stop_);
    if (is_outside(settings_.domain, p)) {
      ++result.outside;
      return;
    }
    const StandingBodies::Part part = bodies_.part_inside(p, step);
    if (part.inside > 0 && part.inside < 1)
      cut_.push_back(p);
    if (part.inside > 0 && even_number(glm::floor(p / step)) >= 1 - part.inside) {
      ++result.in_obstacles[part.body];
      return;
    }
    ++result.placed;
    if (wanted_ == Wanted::counts)
      return;
    if (!settings_.obstacles.empty())
      axes_.push_back(axes_held(p, step, shape));
    initial_.positions.push_back(bodies_.push_out(p));
  }

  /// 1 for each axis along which the lattice goes on, or ends at a wall of the domain, on both
  /// sides of the point, else 0.
  glm::vec3 axes_held(const glm::vec3& p, const glm::vec3& step, const Shape& shape) const {
    glm::vec3 held(1);
    for (int axis = 0; axis < 3; ++axis)
      for (const float way : {-step[axis], step[axis]}) {
        glm::vec3 next = p;
        next[axis] += way;
        if (!is_inside(shape, next) && !is_outside(settings_.domain, next))
          held[axis] = 0;
      }
    return held;
  }

  /// Spreads the particles near cut cells evenly and notes them as loose.
  void pack_near_cuts() {
    const float reach = packed_reach * edge_;
    const PointCells cuts(cut_, reach);
    std::vector<PackedParticle> moves;
    Box around{initial_.positions[0], initial_.positions[0]};
    for (std::uint32_t i = 0; i < initial_.positions.size(); ++i) {
      const glm::vec3& p = initial_.positions[i];
      bool is_near = false;
      cuts.for_near(
          p, [&](std::uint32_t k) { is_near = is_near || glm::distance(p, cut_[k]) < reach; });
      if (!is_near)
        continue;
      moves.push_back({i, axes_[i]});
      initial_.loose.push_back(i);
      around = {glm::min(around.min, p - reach), glm::max(around.max, p + reach)};
    }
    std::vector<glm::vec3> walls = bodies_.samples_in(around, edge_);
    for (const glm::vec3& p : sample_walls(settings_.domain, edge_))
      walls.push_back(p);
    pack(initial_.positions, moves, walls, bodies_, edge_, stop_);
  }

  const Settings& settings_;
  Wanted wanted_;
  Stop stop_;
  StandingBodies bodies_;
  float edge_;  ///< particle_spacing(), m
  std::size_t looked_at_ = 0;
  std::vector<glm::vec3> cut_;   ///< centres of the cells that bodies cut, m
  std::vector<glm::vec3> axes_;  ///< axes_held() of each particle; empty without obstacles
  InitialParticles initial_;
};

}  // namespace

InitialParticles fill_volumes(const Settings& settings, Stop stop) {
  Filling filling(settings, Wanted::particles, stop);
  for (const Volume& volume : settings.fluid.volumes)
    filling.add(volume);
  return filling.take();
}

std::vector<FilledVolume> count_volumes(const Settings& settings) {
  Filling filling(settings, Wanted::counts, nullptr);
  for (const Volume& volume : settings.fluid.volumes)
    filling.add(volume);
  return filling.counts();
}

std::size_t initial_particle_count(const Settings& settings) {
  std::size_t count = 0;
  for (const FilledVolume& volume : count_volumes(settings))
    count += volume.placed;
  return count;
}

Settings as_filled(const Settings& settings) {
  Settings filled = settings;
  filled.fluid.spacing = particle_spacing(settings);
  return filled;
}

GridMap grid_over(const Settings& settings, float cell) {
  const float spacing = settings.fluid.spacing;
  Box box = reach_of(settings);
  for (const Emitter& emitter : settings.fluid.emitters) {
    const Box nozzle = Nozzle(emitter, spacing).bounds();
    box = {glm::min(box.min, nozzle.min), glm::max(box.max, nozzle.max)};
  }
  return GridMap::over(from_glm(box.min - spacing), from_glm(box.max + spacing), cell);
}

FluidConstants constants_of(const FluidSettings& fluid) {
  const float radius = 2 * fluid.spacing;
  const CubicKernel kernel(radius);
  return {.spacing = fluid.spacing,
          .support_radius = radius,
          .rest_density = fluid.rest_density,
          .volume = static_cast<float>(1 / lattice_kernel_sum(kernel, fluid.spacing, radius)),
          .viscosity = fluid.viscosity,
          .wall_viscosity = fluid.wall_viscosity,
          .surface_tension = fluid.surface_tension,
          .contact_angle = fluid.contact_angle};
}

float default_speed_of_sound(const Settings& settings) {
  float speed = 0;
  for (const Volume& volume : settings.fluid.volumes)
    speed = std::max(speed, glm::length(volume.velocity));
  for (const Obstacle& obstacle : settings.obstacles)
    speed = std::max(speed, fastest_speed(obstacle));
  for (const Emitter& emitter : settings.fluid.emitters)
    speed = std::max(speed, emitter.speed);
  float acceleration = glm::length(settings.forces.gravity);
  for (const AccelerationKey& k : settings.forces.body)
    acceleration += glm::length(k.acceleration);
  const glm::vec3 size = settings.domain.max - settings.domain.min;
  const glm::vec3 down = glm::abs(settings.forces.gravity);
  const float height =
      glm::length(down) > 0 ? glm::dot(size, down) / glm::length(down) : glm::length(size);
  const FluidSettings& fluid = settings.fluid;
  const float capillary = 2 * fluid.surface_tension / (fluid.rest_density * fluid.spacing);
  return 10 * std::max(std::sqrt(speed * speed + 2 * acceleration * height + capillary), 1e-3f);
}

}  // namespace spindrift::sim
