#include "sim/start/fill.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "sim/geometry/solid.hpp"

namespace spindrift::sim {
namespace {

/// A length that is this near to a whole number of spacings, in spacings, counts as whole.
constexpr double whole_within = 0.01;

/// The weight, in the choice of a lattice, of the error of a cell's volume against the cell's
/// deformation; both are squares of logarithms.
constexpr double weight_of_volume = 10;

/// The largest factor by which the liquid that a particle represents may differ from spacing³.
constexpr double most_stretch = 1.25;

/// A lattice holds a shape's volume if the relative error of its particles' total is below this.
constexpr double right_within = 0.01;

/// The numbers of layers that may fill a length.
struct Layers {
  std::array<int, 2> counts;  ///< both the same if there is one candidate only
  bool exact;                 ///< whether the length is a whole number of spacings
};

/// @param length in spacings
Layers layers_near(double length) {
  const double nearest = std::round(length);
  const bool exact = nearest >= 1 && std::abs(length - nearest) <= whole_within;
  const int below = static_cast<int>(exact ? nearest : std::floor(length));
  if (exact)
    return {{below, below}, true};
  return {{length < 0.5 ? 0 : std::max(below, 1), length < 0.5 ? 0 : below + 1}, false};
}

/// The lattice whose cells fill a box with least deformation.
/// @param edge of the cube whose volume a cell is to hold, m; nullopt: any volume will do
Lattice best_lattice(const Box& box, float spacing, std::optional<float> edge) {
  const glm::dvec3 size = (glm::dvec3(box.max) - glm::dvec3(box.min)) / double{spacing};
  const Layers near[3] = {layers_near(size.x), layers_near(size.y), layers_near(size.z)};
  const double wanted = edge ? 3 * std::log(double{*edge} / spacing) : 0;
  Lattice best{.origin = box.min, .step = glm::vec3(spacing), .offset = glm::vec3(0.5f)};
  double least = INFINITY;
  for (int choice = 0; choice < 8; ++choice) {
    glm::ivec3 counts;
    double strain = 0, volume = 0;
    glm::vec3 step(spacing);
    for (int axis = 0; axis < 3; ++axis) {
      counts[axis] = near[axis].counts[(choice >> axis) & 1];
      if (counts[axis] == 0)
        return best;
      if (near[axis].exact)
        continue;
      const double stretch = size[axis] / counts[axis];
      step[axis] = static_cast<float>(stretch * spacing);
      strain += std::pow(std::log(stretch), 2);
      volume += std::log(stretch);
    }
    const double cost = strain + (edge ? weight_of_volume * std::pow(volume - wanted, 2) : 0);
    if (cost < least) {
      least = cost;
      best.step = step;
      best.counts = counts;
    }
  }
  return best;
}

/// Whether a lattice is fitted to all faces of the shape's bounding box.
bool fills_like_a_box(const Shape& shape) {
  return glm::all(flat_along(shape));
}

/// The steps of the lattice that fills a shape where any volume of a cell will do, m.
glm::vec3 steps_in(const Shape& shape, float spacing) {
  return glm::mix(glm::vec3(spacing), lattice_in(bounds_of(shape), spacing).step,
                  flat_along(shape));
}

/// Calls f(point) for all points of a lattice that are inside a shape.
template <class F>
void for_points_inside(const Shape& shape, const Lattice& lattice, Stop stop, F f) {
  const bool all = std::holds_alternative<Box>(shape);
  const Solid solid = solid_of(shape);
  for (int k = 0; k < lattice.counts.z; ++k)
    for (int j = 0; j < lattice.counts.y; ++j) {
      throw_if_stopped(stop);
      for (int i = 0; i < lattice.counts.x; ++i) {
        const glm::vec3 p = lattice.point({i, j, k});
        if (all || solid.contains(p))
          f(p);
      }
    }
}

/// The lattices that may fill a round shape: along each axis without flat ends, either a point or
/// the middle between two points is at the shape's centre.
std::vector<Lattice> round_lattices(const Shape& shape, float spacing, float edge) {
  const Box bounds = bounds_of(shape);
  const Lattice along = lattice_in(bounds, spacing);
  const glm::bvec3 flat = flat_along(shape);
  const int fixed = (flat.x ? 1 : 0) | (flat.y ? 2 : 0) | (flat.z ? 4 : 0);
  std::vector<Lattice> lattices;
  for (int choice = 0; choice < 8; ++choice) {
    if ((choice & fixed) != 0)
      continue;
    Lattice lattice{.origin = 0.5f * (bounds.min + bounds.max), .step = glm::vec3(edge)};
    if (const Sphere* ball = std::get_if<Sphere>(&shape))
      lattice.origin = ball->center;
    lattice.first = -glm::ivec3(glm::ceil(0.5f * (bounds.max - bounds.min) / edge));
    for (int k = 0; k < 3; ++k)
      lattice.offset[k] = (choice >> k) & 1 ? 0.5f : 0.f;
    lattice.counts = -2 * lattice.first + 1;
    lattice.origin = glm::mix(lattice.origin, along.origin, flat);
    lattice.step = glm::mix(lattice.step, along.step, flat);
    lattice.offset = glm::mix(lattice.offset, along.offset, flat);
    lattice.first = glm::mix(lattice.first, along.first, flat);
    lattice.counts = glm::mix(lattice.counts, along.counts, flat);
    lattices.push_back(lattice);
  }
  return lattices;
}

/// The first of round_lattices() that holds the shape's volume, or else the one that comes nearest
/// to it; an empty lattice only if none of them has a point inside.
Lattice round_lattice(const Shape& shape, float spacing, float edge, Stop stop) {
  const double wanted = volume_of(shape) / std::pow(double{edge}, 3);
  Lattice best;
  double least = INFINITY;
  for (const Lattice& lattice : round_lattices(shape, spacing, edge)) {
    std::int64_t count = 0;
    for_points_inside(shape, lattice, stop, [&](const glm::vec3&) { ++count; });
    if (count == 0)
      continue;
    const double misfit = std::abs(static_cast<double>(count) / wanted - 1);
    if (misfit < least) {
      least = misfit;
      best = lattice;
    }
    if (least < right_within)
      break;
  }
  return best;
}

}  // namespace

Lattice lattice_in(const Box& box, float spacing) {
  return best_lattice(box, spacing, std::nullopt);
}

Lattice lattice_in(const Box& box, float spacing, float edge) {
  return best_lattice(box, spacing, edge);
}

float particle_spacing(const Settings& settings) {
  const float spacing = settings.fluid.spacing;
  double largest = 0;
  glm::vec3 step(spacing);
  for (const Volume& volume : settings.fluid.volumes) {
    const Shape inside = within_domain(volume.shape, settings.domain);
    const double size = volume_of(inside);
    if (size > largest) {
      largest = size;
      step = steps_in(inside, spacing);
    }
  }
  if (step == glm::vec3(spacing))
    return spacing;
  const double stretch = double{step.x} * step.y * step.z / std::pow(double{spacing}, 3);
  return static_cast<float>(spacing *
                            std::cbrt(std::clamp(stretch, 1 / most_stretch, most_stretch)));
}

FilledShape fill_shape(const Shape& shape, float spacing, float edge, Stop stop) {
  const Lattice lattice = fills_like_a_box(shape) ? lattice_in(bounds_of(shape), spacing, edge)
                                                  : round_lattice(shape, spacing, edge, stop);
  FilledShape filled{{}, lattice.step};
  for_points_inside(shape, lattice, stop, [&](const glm::vec3& p) { filled.points.push_back(p); });
  return filled;
}

Shape within_domain(const Shape& shape, const DomainSettings& domain) {
  if (const Box* box = std::get_if<Box>(&shape))
    return Box{glm::max(box->min, domain.min), glm::min(box->max, domain.max)};
  return shape;
}

}  // namespace spindrift::sim
