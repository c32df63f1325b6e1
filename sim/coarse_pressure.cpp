#include "sim/coarse_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "sim/lattice.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// A particle is spray or surface, and keeps no pressure, if its density is further below the rest
/// density than its pressure can hold it up, by this ratio.
constexpr float slack = 0.03f;

}  // namespace

CoarsePressure::CoarsePressure(const FluidConstants& constants)
    : kernel_(constants.spacing, constants.support_radius) {
  double all = 0, squared_x = 0, abs_x = 0;
  for_lattice_points(constants.spacing, constants.support_radius, [&](const Vec3<float>& p) {
    const double w = kernel_.weight(dot(p, p));
    all += w;
    squared_x += w * p.x * p.x;
    abs_x += w * std::abs(p.x);
  });
  lattice_conductance_ = static_cast<float>(all);
  // Pressure that falls linearly drops, across a plane, by the distance of a pair of particles; by
  // a whole cell where it is flat in cells. The pairs that cross a plane are as many as they are
  // long.
  aggregate_factor_ = static_cast<float>(abs_x / squared_x);  // times the cell size, below
}

void CoarsePressure::build(const StepContext& s, float delta) {
  map_ = *s.map;
  count_ = static_cast<std::uint32_t>(s.grid->cell_count());
  neighbours_.build(map_, s.grid->view());
  const std::uint32_t batches = (count_ + lane_count - 1) / lane_count;
  grow(conductance_, CellNeighbourView::place(batches * lane_count, 0));
  s.executor.for_each("coarse grid", batches, [&](std::uint32_t b) {
    std::fill_n(&conductance_[CellNeighbourView::place(b * lane_count, 0)], slots * lane_count,
                0.f);
  });
  for (ScalarField* field : {&inverse_diagonal_, &pressure_, &residual_, &direction_, &image_})
    field->resize(count_);
  find_active(s, delta);
  s.executor.for_each("coarse grid", count_, [&](std::uint32_t c) { connect(s, c); });
  s.executor.for_each("coarse grid", count_, [&](std::uint32_t c) {
    float around = 0;
    for (int t = 0; t < slots; ++t)
      around += conductance_[CellNeighbourView::place(c, t)];
    float particles = 0;
    for (std::uint32_t i = s.grid->cell_begin(c); i < s.grid->cell_begin(c + 1); ++i)
      particles += active_[i];
    const float inside = conductance_between(s, c, c);
    const float lacking =
        lattice_conductance_ * particles - inside - around - conductance_to_walls(s, c);
    // The last part keeps a body of liquid without any surface solvable.
    const float diagonal =
        around + std::max(0.f, lacking) + 1e-4f * lattice_conductance_ * particles;
    conductance_[CellNeighbourView::place(c, self)] = diagonal;
    inverse_diagonal_[c] = diagonal > 0 ? 1 / diagonal : 0.f;
  });
  attach_walls(s);
}

void CoarsePressure::find_active(const StepContext& s, float delta) {
  const float *pressure = s.particles.step_pressure.data(),
              *ratio = s.particles.density_ratio.data();
  float* active = active_.resized(s.particles.count);
  s.executor.for_each("coarse grid", s.particles.count, [=](std::uint32_t i) {
    active[i] = pressure[i] / delta + ratio[i] > 1 - slack ? 1.f : 0.f;
  });
}

/// Links a cell with those that come after it in key order, both ways.
void CoarsePressure::connect(const StepContext& s, std::uint32_t cell) {
  for (int slot = self + 1; slot < slots; ++slot) {
    const std::int32_t at = neighbours_.view().at(cell, slot);
    if (at < 0)
      continue;
    const auto other = static_cast<std::uint32_t>(at);
    conductance_[CellNeighbourView::place(cell, slot)] =
        conductance_[CellNeighbourView::place(other, slots - 1 - slot)] =
            conductance_between(s, cell, other);
  }
}

/// Σ w over all pairs of active particles, one of cell a and one of cell b, 1/m².
float CoarsePressure::conductance_between(const StepContext& s, std::uint32_t a,
                                          std::uint32_t b) const {
  constexpr IndexLanes lane{0, 1, 2, 3, 4, 5, 6, 7};
  const Vec3Arrays x = s.particles.drifted_position.view();
  const std::uint32_t begin = s.grid->cell_begin(b), end = s.grid->cell_begin(b + 1);
  const float* active = active_.data();
  Lanes total{};
  for (std::uint32_t i = s.grid->cell_begin(a); i < s.grid->cell_begin(a + 1); ++i) {
    if (active[i] == 0)
      continue;
    const Vec3<float> xi = x[i];
    for (std::uint32_t j = begin; j < end; j += lane_count) {
      const Vec3<Lanes> d{xi.x - consecutive(x.x + j), xi.y - consecutive(x.y + j),
                          xi.z - consecutive(x.z + j)};
      const Lanes w = kernel_.weight(dot(d, d)) * consecutive(active + j);
      const Lanes zero{};
      total += lane < static_cast<std::int32_t>(end - j) ? w : zero;
    }
  }
  return reduce(total);
}

float CoarsePressure::conductance_to_walls(const StepContext& s, std::uint32_t cell) const {
  const Vec3Arrays x = s.particles.drifted_position.view();
  float sum = 0;
  for (std::uint32_t i = s.grid->cell_begin(cell); i < s.grid->cell_begin(cell + 1); ++i) {
    const Vec3<float> xi = x[i];
    sum += active_[i] * s.boundary.neighbours.sum(i, [&](auto b) {
      const auto d = xi - s.boundary.position[b];
      return load(s.boundary.volume, b) * kernel_.weight(dot(d, d));
    });
  }
  return sum / s.constants.volume;
}

/// A boundary sample has the pressure of the particle nearest to it, and adds its residual there.
void CoarsePressure::attach_walls(const StepContext& s) {
  const BoundaryView& solid = s.boundary;
  nearest_.resize(solid.wet_count);
  wet_cell_.resize(solid.wet_count);
  const Vec3Arrays x = s.particles.drifted_position.view();
  s.executor.for_each("coarse grid", solid.wet_count, [&](std::uint32_t k) {
    const std::uint32_t b = solid.wet[k];
    const Vec3<float> xb = solid.position[b];
    const std::uint32_t* j = solid.fluid.list(b);
    float best = INFINITY;
    for (std::uint32_t left = *j++ * lane_count; left > 0; --left, ++j) {
      const Vec3<float> d = xb - x[*j];
      if (dot(d, d) < best) {
        best = dot(d, d);
        nearest_[k] = *j;
      }
    }
    wet_cell_[k] =
        static_cast<std::uint32_t>(s.grid->view().first_cell_from(map_.key(x[nearest_[k]])));
  });
}

/// Solves for pressure_ from residual_, with the diagonal as preconditioner, to a hundredth.
void CoarsePressure::conjugate_gradients(Executor& executor) {
  constexpr int most_iterations = 200;
  constexpr double squared_tolerance = 1e-4;
  pressure_.fill(0);
  direction_.fill(0);
  float *p = pressure_.data(), *r = residual_.data(), *d = direction_.data(),
        *image = image_.data();
  const float *inverse = inverse_diagonal_.data(), *weights = conductance_.data();
  const CellNeighbourView neighbours = neighbours_.view();
  /// Moves by a step along the direction; returns the residual's squared norm.
  const auto advance = [&](float step) {
    return executor
        .reduce<Sum>("coarse pressure", count_,
                     [=](std::uint32_t c) {
                       p[c] += step * d[c];
                       r[c] -= step * image[c];
                       return Sum{double{r[c]} * r[c] * inverse[c]};
                     })
        .value;
  };
  image_.fill(0);
  double squared = advance(0), before = 0;
  const double goal = squared_tolerance * squared;
  for (int k = 0; k < most_iterations && squared > goal; ++k) {
    const float beta = k > 0 ? static_cast<float>(squared / before) : 0.f;
    executor.for_each("coarse pressure", count_,
                      [=](std::uint32_t c) { d[c] = r[c] * inverse[c] + beta * d[c]; });
    const double curvature = executor
                                 .reduce<Sum>("coarse pressure", count_,
                                              [=](std::uint32_t c) {
                                                neighbours.apply(c, weights, d, image);
                                                return Sum{double{image[c]} * d[c]};
                                              })
                                 .value;
    if (!(curvature > 0))
      return;
    before = squared;
    squared = advance(static_cast<float>(squared / curvature));
  }
}

CoarsePressure::Around CoarsePressure::pressures_around(std::uint32_t cell) const {
  Around around;
  for (int t = 0; t < slots; ++t) {
    const std::int32_t other = neighbours_.view().at(cell, t);
    around[static_cast<std::size_t>(t)] =
        pressure_[other >= 0 ? static_cast<std::uint32_t>(other) : cell];
  }
  return around;
}

std::size_t CoarsePressure::memory_bytes() const {
  return active_.memory_bytes() + neighbours_.memory_bytes() + conductance_.capacity() * 4 +
         5 * pressure_.memory_bytes() + (nearest_.capacity() + wet_cell_.capacity()) * 4;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
