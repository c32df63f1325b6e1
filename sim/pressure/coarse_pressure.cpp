#include "sim/pressure/coarse_pressure.hpp"

#include <algorithm>
#include <cmath>

#include "sim/core/lattice.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// A particle is spray or surface, and keeps no pressure, if its density ratio is below 1 by this
/// much more than its pressure can hold it there.
constexpr float slack = 0.03f;

/// Share of the lattice's conductance that a disordered neighbourhood may lack without counting as
/// free surface. Counted as one, it would let pressure leak away within some twenty spacings, and a
/// tall column fall.
constexpr float disorder = 0.03f;

constexpr int slots = CellNeighbourView::slots, self = CellNeighbourView::self;

/// The particles and boundary particles whose pairs make up the conductances.
struct Pairs {
  ConductanceKernel kernel;
  CellGridView grid;
  PointView position;
  const float* active;            ///< 1 for particles that may have pressure, else 0
  NeighbourView wall_neighbours;  ///< the boundary particles near each particle
  PointView walls;                ///< the boundary particles, with their volumes, m³

  /// Σ w over all pairs of one active particle of cell a and one of cell b, 1/m².
  SPINDRIFT_HD float between(std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t begin = grid.cell_begin(a), end = grid.cell_begin(a + 1);
    RunSum total;
    total.add(grid.cell_begin(b), grid.cell_begin(b + 1), [&](auto j) {
      const auto xj = position[j];
      auto sum = 0.f * xj.x;
      for (std::uint32_t i = begin; i < end; ++i) {
        const auto d = position[i] - xj;
        sum += active[i] * kernel.weight(dot(d, d));
      }
      return load(active, j) * sum;
    });
    return total.value();
  }

  /// Σ V_b w over all pairs of an active particle of a cell and a boundary particle, m.
  SPINDRIFT_HD float to_walls(std::uint32_t cell) const {
    float sum = 0;
    for (std::uint32_t i = grid.cell_begin(cell); i < grid.cell_begin(cell + 1); ++i) {
      const Vec3<float> xi = position[i];
      sum += active[i] * wall_neighbours.sum(i, [&](auto b) {
        const auto [xb, volume] = walls.point(b);
        const auto d = xi - xb;
        return volume * kernel.weight(dot(d, d));
      });
    }
    return sum;
  }
};

/// Marks the particles that count: 1, else 0.
void mark_active(const StepContext& s, float delta, float* active) {
  const PointView at = s.particles.drifted_position.view();
  const float* ratio = s.particles.density_ratio.data();
  s.executor.for_each("coarse grid", s.particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
    active[i] = at.value(i) / delta + ratio[i] > 1 - slack ? 1.f : 0.f;
  });
}

/// The number of cells, rounded up to whole batches.
std::uint32_t rounded_up(std::uint32_t count) {
  return (count + lane_count - 1) / lane_count * lane_count;
}

/// Finds the matrix of a system. A conductance is computed once for each pair of cells, by the one
/// that comes first in key order, and written to both.
/// @param of_lattice Σ w over a full lattice, the particle itself included, 1/m²
void find_conductances(const StepContext& s, const Pairs& all_pairs, float of_lattice,
                       const CoarseSystem& system) {
  float *conductance = system.conductance, *inverse_diagonal = system.inverse_diagonal;
  const CellNeighbourView neighbours = system.neighbours;
  const Pairs pairs = all_pairs;
  s.executor.for_each("coarse grid", rounded_up(system.count), [=] SPINDRIFT_HD(std::uint32_t c) {
    for (int t = 0; t < slots; ++t)
      conductance[CellNeighbourView::place(c, t)] = 0;
  });
  s.executor.for_each("coarse grid", system.count, [=] SPINDRIFT_HD(std::uint32_t c) {
    for (int t = self + 1; t < slots; ++t) {
      const std::int32_t at = neighbours.at(c, t);
      if (at < 0)
        continue;
      const auto other = static_cast<std::uint32_t>(at);
      conductance[CellNeighbourView::place(c, t)] =
          conductance[CellNeighbourView::place(other, slots - 1 - t)] = pairs.between(c, other);
    }
  });
  const float volume = s.constants.volume;
  s.executor.for_each("coarse grid", system.count, [=] SPINDRIFT_HD(std::uint32_t c) {
    float around = 0;
    for (int t = 0; t < slots; ++t)
      around += conductance[CellNeighbourView::place(c, t)];
    float particles = 0;
    for (std::uint32_t i = pairs.grid.cell_begin(c); i < pairs.grid.cell_begin(c + 1); ++i)
      particles += pairs.active[i];
    const float inside = pairs.between(c, c);
    const float full = of_lattice * particles;
    const float lacking = full - inside - around - pairs.to_walls(c) / volume;
    // The last term keeps the system of a body of liquid without free surface solvable.
    const float diagonal = around + std::max(0.f, lacking - disorder * full) + 1e-6f * full;
    conductance[CellNeighbourView::place(c, self)] = diagonal;
    inverse_diagonal[c] = diagonal > 0 ? 1 / diagonal : 0.f;
  });
}

/// A boundary particle has the pressure of the fluid particle nearest to it, and adds its residual
/// there.
void attach_walls(const StepContext& s, std::uint32_t* nearest, std::uint32_t* wet_cell) {
  const BoundaryView solid = s.boundary;
  const PointView x = s.particles.drifted_position.view();
  const CellGridView grid = s.grid;
  const GridMap map = *s.map;
  s.executor.for_each("coarse grid", solid.wet_count, [=] SPINDRIFT_HD(std::uint32_t k) {
    const std::uint32_t b = solid.wet[k];
    const Vec3<float> xb = solid.position[b];
    float best = INFINITY;
    std::uint32_t found = 0;
    solid.fluid.for_each(b, [&](std::uint32_t j) {
      const Vec3<float> d = xb - x[j];
      if (dot(d, d) < best) {
        best = dot(d, d);
        found = j;
      }
    });
    nearest[k] = found;
    wet_cell[k] = grid.first_cell_from(map.key(x[found]));
  });
}

}  // namespace

/// The host looks at the iteration only now and then; loops that are begun
/// after its end do nothing.
void solve(Executor& executor, const CoarseSystem& system, Kept<ConjugateGradients>& iteration) {
  constexpr int most_iterations = 200;
  constexpr double squared_tolerance = 1e-4;
  constexpr std::string_view phase = "coarse pressure";
  const std::uint32_t count = system.count;
  float *p = system.pressure, *r = system.residual, *d = system.direction, *image = system.image;
  const float *inverse = system.inverse_diagonal, *weights = system.conductance;
  const CellNeighbourView neighbours = system.neighbours;
  const auto begin = [=] SPINDRIFT_HD(std::uint32_t c) {
    p[c] = d[c] = 0;
    return Sum{double{r[c]} * r[c] * inverse[c]};
  };
  const auto set_goal = [=] SPINDRIFT_HD(ConjugateGradients & it, const Sum& squared) {
    it = ConjugateGradients::to(squared_tolerance, squared.value);
  };
  executor.reduce_to<Sum>(phase, count, iteration, begin, set_goal);
  for (int k = 0; k < most_iterations; ++k) {
    if (k % Kept<ConjugateGradients>::look_every == 0 && !iteration.look().goes_on)
      return;
    const auto last = iteration.view();
    executor.for_each(phase, count, [=] SPINDRIFT_HD(std::uint32_t c) {
      if (last->goes_on)
        d[c] = r[c] * inverse[c] + last->beta * d[c];
    });
    const auto apply = [=] SPINDRIFT_HD(std::uint32_t c) {
      if (!last->goes_on)
        return Sum{};
      neighbours.apply(c, weights, d, image);
      return Sum{double{image[c]} * d[c]};
    };
    const auto find_step = [=] SPINDRIFT_HD(ConjugateGradients & it, const Sum& curvature) {
      it.find_step(curvature.value);
    };
    executor.reduce_to<Sum>(phase, count, iteration, apply, find_step);
    const auto now = iteration.view();
    const auto go = [=] SPINDRIFT_HD(std::uint32_t c) {
      if (!now->goes_on)
        return Sum{};
      p[c] += now->step * d[c];
      r[c] -= now->step * image[c];
      return Sum{double{r[c]} * r[c] * inverse[c]};
    };
    const auto find_beta = [=] SPINDRIFT_HD(ConjugateGradients & it, const Sum& squared) {
      it.find_beta(squared.value);
    };
    executor.reduce_to<Sum>(phase, count, iteration, go, find_beta);
  }
}

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
  // Between the two particles of a pair across a plane, pressure that falls linearly drops over
  // their distance, but over a whole cell where it is flat in cells. The number of pairs that cross
  // a plane is proportional to their distance. The factor is yet to be multiplied by the cell size.
  aggregate_factor_ = static_cast<float>(abs_x / squared_x);
}

void CoarsePressure::build(const StepContext& s, float delta) {
  count_ = s.grid.cell_count;
  neighbours_.build(*s.map, s.grid);
  for (ScalarField* field : {&inverse_diagonal_, &pressure_, &residual_, &direction_, &image_})
    field->resize(count_);
  grow(nearest_, s.boundary.wet_count);
  grow(wet_cell_, s.boundary.wet_count);
  view_ = {.map = *s.map,
           .grid = s.grid,
           .neighbours = neighbours_.view(),
           .position = s.particles.drifted_position.view(),
           .pressure = pressure_.data(),
           .nearest = nearest_.data(),
           .wet_cell = wet_cell_.data()};
  mark_active(s, delta, active_.resized(s.particles.count));
  grow(conductance_, CellNeighbourView::place(rounded_up(count_), 0));
  const Pairs pairs{kernel_,
                    s.grid,
                    s.particles.drifted_position.view(),
                    active_.data(),
                    s.boundary.neighbours,
                    s.boundary.position};
  find_conductances(s, pairs, lattice_conductance_, system());
  attach_walls(s, nearest_.data(), wet_cell_.data());
}

std::size_t CoarsePressure::memory_bytes() const {
  return bytes_of(active_, neighbours_, conductance_, nearest_, wet_cell_) +
         5 * bytes_of(pressure_);
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
