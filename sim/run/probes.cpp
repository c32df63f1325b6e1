#include "sim/run/probes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim/core/kernels.hpp"
#include "sim/core/lattice.hpp"
#include "sim/start/initial.hpp"

namespace spindrift::sim {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr int bulk_neighbours = 5;

/// m³, as in the equations of motion: a full lattice has the rest density.
double particle_volume(float spacing) {
  const float radius = 2 * spacing;
  return 1 / lattice_kernel_sum(CubicKernel(radius), spacing, radius);
}

/// A particle, or its mirror image, near a vertical.
struct ColumnParticle {
  float y;                 ///< m
  float squared_distance;  ///< from the vertical, m²
  auto operator<=>(const ColumnParticle&) const = default;
};

/// Those closer to the vertical through (x, z) than the radius that are seen from there, from below
/// to above.
std::vector<ColumnParticle> column_at(const Frame& frame, float radius,
                                      const DomainSettings& domain, float x, float z,
                                      const Sight& sight) {
  std::vector<ColumnParticle> column;
  for (const glm::vec3& p : frame.positions) {
    const bool is_near = std::abs(p.x - x) < radius && std::abs(p.z - z) < radius;
    if (is_near && !sight.is_free(p, {x, p.y, z}))
      continue;
    for (const float px : {p.x, 2 * domain.min.x - p.x, 2 * domain.max.x - p.x}) {
      if (!(std::abs(px - x) < radius))
        continue;
      for (const float pz : {p.z, 2 * domain.min.z - p.z, 2 * domain.max.z - p.z}) {
        const float squared = (px - x) * (px - x) + (pz - z) * (pz - z);
        if (squared < radius * radius)
          column.push_back({p.y, squared});
      }
    }
  }
  std::sort(column.begin(), column.end());
  return column;
}

double kernel_sum(const std::vector<ColumnParticle>& column, const CubicKernel& kernel,
                  float radius, double y) {
  const auto below = [](const ColumnParticle& p, double height) { return p.y < height; };
  double sum = 0;
  for (auto p = std::lower_bound(column.begin(), column.end(), y - radius, below);
       p != column.end() && p->y < y + radius; ++p) {
    const auto dy = static_cast<float>(y - p->y);
    sum += kernel.value(std::sqrt(p->squared_distance + dy * dy));
  }
  return sum;
}

}  // namespace

double surface_height(const Frame& frame, float spacing, const DomainSettings& domain, float x,
                      float z, const Sight& sight) {
  const float radius = 2 * spacing;
  const CubicKernel kernel(radius);
  const auto column = column_at(frame, radius, domain, x, z, sight);
  if (column.empty())
    return nothing;
  const double half = 0.5 / particle_volume(spacing);
  const auto is_liquid = [&](double y) { return kernel_sum(column, kernel, radius, y) >= half; };
  const double step = 0.25 * spacing;
  double above = double{column.back().y} + radius, below = above - step;
  for (; !is_liquid(below); above = below, below -= step)
    if (below < column.front().y)
      return nothing;
  while (above - below > 1e-4 * spacing) {
    const double middle = 0.5 * (above + below);
    (is_liquid(middle) ? below : above) = middle;
  }
  return 0.5 * (above + below);
}

double pressure_at(const Frame& frame, float spacing, const glm::vec3& point, const Sight& sight) {
  const float radius = 2 * spacing;
  const CubicKernel kernel(radius);
  double sum = 0, weights = 0;
  for (std::size_t i = 0; i < frame.positions.size(); ++i) {
    const float weight = kernel.value(glm::distance(frame.positions[i], point));
    if (!(weight > 0) || !sight.is_free(frame.positions[i], point))
      continue;
    sum += double{weight} * frame.pressures[i];
    weights += weight;
  }
  return weights > 0 ? sum / weights : 0;
}

double front_position(const Frame& frame, float spacing, Direction direction) {
  const int axis = static_cast<int>(direction) / 2;
  const float sign = static_cast<int>(direction) % 2 == 0 ? 1.f : -1.f;
  const float radius = 2 * spacing;
  std::vector<glm::vec3> x = frame.positions;  // from the foremost on
  std::sort(x.begin(), x.end(), [&](const glm::vec3& a, const glm::vec3& b) {
    return sign * a[axis] > sign * b[axis];
  });
  for (std::size_t i = 0, begin = 0; i < x.size(); ++i) {
    while (std::abs(x[begin][axis] - x[i][axis]) >= radius)
      ++begin;
    int neighbours = -1;  // less the particle itself
    for (std::size_t j = begin; j < x.size() && std::abs(x[j][axis] - x[i][axis]) < radius; ++j)
      neighbours += glm::distance(x[j], x[i]) < radius;
    if (neighbours >= bulk_neighbours)
      return double{x[i][axis]} + 0.5 * double{sign} * spacing;
  }
  return nothing;
}

Energy energy_of(const Frame& frame, const Settings& settings) {
  const glm::vec3 g = settings.forces.gravity;
  const glm::bvec3 upwards = glm::greaterThan(g, glm::vec3(0));
  const glm::dvec3 lowest(glm::mix(settings.domain.min, settings.domain.max, upwards));
  double squared_speed = 0, height = 0;
  for (const glm::vec3& v : frame.velocities)
    squared_speed += glm::dot(glm::dvec3(v), glm::dvec3(v));
  for (const glm::vec3& p : frame.positions)
    height -= glm::dot(glm::dvec3(p) - lowest, glm::dvec3(g));
  const double mass = double{settings.fluid.rest_density} * particle_volume(settings.fluid.spacing);
  return {0.5 * mass * squared_speed, mass * height};
}

Extent extent_of(const Frame& frame, float spacing) {
  if (frame.positions.empty())
    return {};
  glm::vec3 min = frame.positions.front(), max = min;
  for (const glm::vec3& p : frame.positions) {
    min = glm::min(min, p);
    max = glm::max(max, p);
  }
  const double half = 0.5 * spacing;
  return {static_cast<double>(frame.positions.size()) * particle_volume(spacing),
          glm::dvec3(min) - half, glm::dvec3(max) + half};
}

namespace {

// One overload of each for every kind of probe.
using Columns = std::vector<ProbeColumn>;
using Values = std::vector<double>;

Columns columns_of(const SurfaceHeightProbe&) {
  return {{"", "m"}};
}
Columns columns_of(const PressureProbe&) {
  return {{"", "Pa"}};
}
Columns columns_of(const FrontProbe&) {
  return {{"", "m"}};
}
Columns columns_of(const EnergyProbe&) {
  return {{"_kinetic", "J"}, {"_potential", "J"}, {"_total", "J"}};
}
Columns columns_of(const VolumeProbe&) {
  return {{"", "m3"},      {"_min_x", "m"}, {"_min_y", "m"}, {"_min_z", "m"},
          {"_max_x", "m"}, {"_max_y", "m"}, {"_max_z", "m"}};
}

Values values_of(const SurfaceHeightProbe& probe, const Frame& frame, const Settings& s) {
  return {surface_height(frame, s.fluid.spacing, s.domain, probe.x, probe.z, Sight(s, frame.time))};
}
Values values_of(const PressureProbe& probe, const Frame& frame, const Settings& s) {
  return {pressure_at(frame, s.fluid.spacing, probe.point, Sight(s, frame.time))};
}
Values values_of(const FrontProbe& probe, const Frame& frame, const Settings& s) {
  return {front_position(frame, s.fluid.spacing, probe.direction)};
}
Values values_of(const EnergyProbe&, const Frame& frame, const Settings& s) {
  const Energy e = energy_of(frame, s);
  return {e.kinetic, e.potential, e.kinetic + e.potential};
}
Values values_of(const VolumeProbe&, const Frame& frame, const Settings& s) {
  const Extent e = extent_of(frame, s.fluid.spacing);
  return {e.volume, e.min.x, e.min.y, e.min.z, e.max.x, e.max.y, e.max.z};
}

}  // namespace

std::vector<ProbeColumn> probe_columns(const Probe& probe) {
  Columns columns =
      std::visit([](const auto& quantity) { return columns_of(quantity); }, probe.quantity);
  for (ProbeColumn& column : columns)
    column.name.insert(0, probe.name);
  return columns;
}

std::vector<double> measure(const Probe& probe, const Frame& frame, const Settings& settings) {
  const Settings filled = as_filled(settings);
  return std::visit([&](const auto& quantity) { return values_of(quantity, frame, filled); },
                    probe.quantity);
}

}  // namespace spindrift::sim
