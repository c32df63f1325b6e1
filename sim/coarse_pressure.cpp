#include "sim/coarse_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "sim/lattice.hpp"

namespace spindrift::sim {
namespace {

/// A particle is spray or surface, and keeps no pressure, if its density is further below the rest
/// density than its pressure can hold it up, by this ratio.
constexpr float slack = 0.03f;

/// Weights of the three cells around by the quadratic B-spline; `place` in cells.
std::array<float, 3> spline_weights(float place) {
  const float t = place - std::floor(place) - 0.5f;
  return {0.5f * (0.5f - t) * (0.5f - t), 0.75f - t * t, 0.5f * (0.5f + t) * (0.5f + t)};
}

Lanes consecutive(const float* a) {
  Lanes v;
  __builtin_memcpy(&v, a, sizeof v);
  return v;
}

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
  neighbour_.assign(std::size_t{slots} * count_, -1);
  conductance_.assign(std::size_t{slots} * count_, 0.f);
  for (auto* field : {&diagonal_, &pressure_, &residual_, &direction_, &image_})
    field->resize(count_);
  find_active(s, delta);
  s.executor.for_each("coarse grid", count_, [&](std::uint32_t c) { connect(s, c); });
  s.executor.for_each("coarse grid", count_, [&](std::uint32_t c) {
    const float* w = &conductance_[std::size_t{slots} * c];
    float around = 0;
    for (int t = 0; t < slots; ++t)
      around += w[t];
    float particles = 0;
    for (std::uint32_t i = s.grid->cell_begin(c); i < s.grid->cell_begin(c + 1); ++i)
      particles += active_[i];
    const float inside = conductance_between(s, c, c);
    const float lacking =
        lattice_conductance_ * particles - inside - around - conductance_to_walls(s, c);
    // The last part keeps a body of liquid without any surface solvable.
    diagonal_[c] = around + std::max(0.f, lacking) + 1e-4f * lattice_conductance_ * particles;
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

/// Links a cell with itself and the cells that come after it in key order, both ways.
void CoarsePressure::connect(const StepContext& s, std::uint32_t cell) {
  const CellGrid& grid = *s.grid;
  const auto link = [&](int slot, std::uint32_t other) {
    const float w = conductance_between(s, cell, other);
    neighbour_[std::size_t{slots} * cell + slot] = static_cast<std::int32_t>(other);
    neighbour_[std::size_t{slots} * other + (slots - 1 - slot)] = static_cast<std::int32_t>(cell);
    conductance_[std::size_t{slots} * cell + slot] = w;
    conductance_[std::size_t{slots} * other + (slots - 1 - slot)] = w;
  };
  neighbour_[std::size_t{slots} * cell + self] = static_cast<std::int32_t>(cell);
  const std::uint64_t key = grid.cell_key(cell);
  if (cell + 1 < count_ && grid.cell_key(cell + 1) == key + 1)
    link(self + 1, cell + 1);
  for (int row = 5; row < 9; ++row) {
    const int dy = row % 3 - 1, dz = row / 3 - 1;
    const std::uint64_t low = key + static_cast<std::uint64_t>(map_.nx * (dy + map_.ny * dz)) - 1;
    for (std::size_t other = grid.first_cell_from(low);
         other < count_ && grid.cell_key(other) <= low + 2; ++other)
      link(3 * row + static_cast<int>(grid.cell_key(other) - low),
           static_cast<std::uint32_t>(other));
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
    wet_cell_[k] = static_cast<std::uint32_t>(s.grid->first_cell_from(map_.key(x[nearest_[k]])));
  });
}

float CoarsePressure::applied(std::uint32_t cell, const std::vector<float>& u) const {
  const std::int32_t* other = &neighbour_[std::size_t{slots} * cell];
  const float* w = &conductance_[std::size_t{slots} * cell];
  float sum = diagonal_[cell] * u[cell];
  for (int t = 0; t < slots; ++t)
    if (other[t] >= 0)
      sum -= w[t] * u[static_cast<std::size_t>(other[t])];
  return sum;
}

/// Solves for pressure_ from residual_, with the diagonal as preconditioner, to a hundredth.
void CoarsePressure::conjugate_gradients(Executor& executor) {
  constexpr int most_iterations = 200;
  constexpr double squared_tolerance = 1e-4;
  const auto inverse = [&](std::uint32_t c) { return diagonal_[c] > 0 ? 1 / diagonal_[c] : 0.f; };
  const auto norm = [&] {
    return executor
        .reduce<Sum>(
            "coarse pressure", count_,
            [&](std::uint32_t c) { return Sum{double{residual_[c]} * residual_[c] * inverse(c)}; })
        .value;
  };
  std::fill(pressure_.begin(), pressure_.end(), 0.f);
  std::fill(direction_.begin(), direction_.end(), 0.f);
  double squared = norm(), before = 0;
  const double goal = squared_tolerance * squared;
  for (int k = 0; k < most_iterations && squared > goal; ++k) {
    const float beta = k > 0 ? static_cast<float>(squared / before) : 0.f;
    executor.for_each("coarse pressure", count_, [&](std::uint32_t c) {
      direction_[c] = residual_[c] * inverse(c) + beta * direction_[c];
    });
    const double curvature = executor
                                 .reduce<Sum>("coarse pressure", count_,
                                              [&](std::uint32_t c) {
                                                image_[c] = applied(c, direction_);
                                                return Sum{double{image_[c]} * direction_[c]};
                                              })
                                 .value;
    if (!(curvature > 0))
      return;
    const float step = static_cast<float>(squared / curvature);
    executor.for_each("coarse pressure", count_, [&](std::uint32_t c) {
      pressure_[c] += step * direction_[c];
      residual_[c] -= step * image_[c];
    });
    before = squared;
    squared = norm();
  }
}

float CoarsePressure::at(const Vec3<float>& x, std::uint32_t cell) const {
  const auto wx = spline_weights((x.x - map_.origin.x) * map_.inverse_cell);
  const auto wy = spline_weights((x.y - map_.origin.y) * map_.inverse_cell);
  const auto wz = spline_weights((x.z - map_.origin.z) * map_.inverse_cell);
  const std::int32_t* other = &neighbour_[std::size_t{slots} * cell];
  const float own = pressure_[cell];
  float sum = 0;
  for (int k = 0, t = 0; k < 3; ++k)
    for (int j = 0; j < 3; ++j)
      for (int i = 0; i < 3; ++i, ++t) {
        const float p = other[t] >= 0 ? pressure_[static_cast<std::size_t>(other[t])] : own;
        sum += wx[i] * wy[j] * wz[k] * p;
      }
  return sum;
}

std::size_t CoarsePressure::memory_bytes() const {
  return active_.memory_bytes() + neighbour_.capacity() * 4 + conductance_.capacity() * 4 +
         5 * pressure_.capacity() * 4 + (nearest_.capacity() + wet_cell_.capacity()) * 4;
}

}  // namespace spindrift::sim
