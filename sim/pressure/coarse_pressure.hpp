// What particles cannot tell each other quickly. An iteration over particles carries pressure one
// support radius on; a column of a hundred particles would need a hundred iterations to feel its
// own weight. On the grid of the neighbour search's cells, nine times fewer unknowns, the same
// equation is solved across the whole liquid at once.
//
// The cells are aggregates of their particles: pressure is one number per cell, and a cell's
// residual the sum of its particles'. In ∇²p = Σⱼ wᵢⱼ (pⱼ − pᵢ) two particles have a conductance
// wᵢⱼ between them; between cells it is the sum over their pairs. What a particle's neighbourhood
// lacks is free surface, where pressure is zero. The solution is interpolated by quadratic
// B-splines, which leave no kinks for the particles to mend.
#pragma once

#include <algorithm>
#include <array>

#include "sim/backend/backend.hpp"
#include "sim/core/conjugate_gradients.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Weights of the three cells around by the quadratic B-spline; `place` in cells.
template <class Real>
SPINDRIFT_HD std::array<Real, 3> spline_weights(Real place) {
  const Real t = place - rounded_down(place) - 0.5f;
  return {0.5f * (0.5f - t) * (0.5f - t), 0.75f - t * t, 0.5f * (0.5f + t) * (0.5f + t)};
}

/// The solution, as loops over particles look at it.
struct CoarseView {
  GridMap map;
  CellGridView grid;
  CellNeighbourView neighbours;
  PointView position;                       ///< of the particles, m
  const float* pressure;                    ///< per cell, Pa
  const std::uint32_t *nearest, *wet_cell;  ///< per wet boundary sample: a particle, its cell

  /// f(i, pressure at particle i, Pa) for all particles of a cell.
  template <class F>
  SPINDRIFT_HD void at_particles(std::uint32_t cell, F f) const {
    const Around around = pressures_around(cell);
    for_run(
        grid.cell_begin(cell), grid.cell_begin(cell + 1),
        [&](auto i) { return at(position[i], around); }, f);
  }
  /// Pressure at the wet boundary sample k, Pa: that of the particle nearest to it.
  SPINDRIFT_HD float at_wall(std::uint32_t k) const {
    return at(position[nearest[k]], pressures_around(wet_cell[k]));
  }

 private:
  /// Of a cell and those around it, Pa; its own where there is none.
  using Around = std::array<float, CellNeighbourView::slots>;

  SPINDRIFT_HD Around pressures_around(std::uint32_t cell) const {
    Around around{};
    for (int t = 0; t < CellNeighbourView::slots; ++t) {
      const std::int32_t other = neighbours.at(cell, t);
      around[static_cast<std::size_t>(t)] =
          pressure[other >= 0 ? static_cast<std::uint32_t>(other) : cell];
    }
    return around;
  }

  template <class Real>
  SPINDRIFT_HD Real at(const Vec3<Real>& x, const Around& around) const {
    const auto wx = spline_weights((x.x - map.origin.x) * map.inverse_cell);
    const auto wy = spline_weights((x.y - map.origin.y) * map.inverse_cell);
    const auto wz = spline_weights((x.z - map.origin.z) * map.inverse_cell);
    Real sum{};
    for (std::size_t k = 0, t = 0; k < 3; ++k)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t i = 0; i < 3; ++i, ++t)
          sum += wx[i] * wy[j] * wz[k] * around[t];
    return sum;
  }
};

class CoarsePressure {
 public:
  explicit CoarsePressure(const FluidConstants& constants);

  /// Finds the cells' neighbours and conductances for the particles as they are, of which those
  /// count that are under pressure or nearly dense enough for it.
  /// @param delta pressure per density ratio, δ, Pa
  void build(const StepContext& s, float delta);

  /// What is wrong at a particle or a wet boundary sample, in density ratios.
  struct Error {
    float compression;  ///< ρ/ρ₀ − 1
    float held_up;      ///< how far pressure can hold ρ/ρ₀ below what is wanted, p/δ
  };

  /// The pressure per cell, Pa, that takes away the errors: error(k) is that of particle k for
  /// k < count, then of the wet boundary samples. A cell's errors are added up with their signs,
  /// and only their sum is bounded by what there is of pressure: else the scatter of single
  /// particles would look like compression of the whole, and throw a tall column up.
  template <class F>
  void solve(const StepContext& s, F error);

  /// Of the particles and samples that the last build() was for.
  CoarseView view() const { return view_; }

  std::size_t memory_bytes() const;

  // Parts of build() and solve(); public since CUDA has no loops in private functions.
  void find_active(const StepContext& s, float delta);
  void find_conductances(const StepContext& s);
  void attach_walls(const StepContext& s);
  void conjugate_gradients(Executor& executor);

 private:
  /// Part of the solution that is applied. Pressure outlasts the step in the warm start, so that
  /// with much more the steps swing from one side to the other.
  static constexpr float gain = 0.3f;

  ConductanceKernel kernel_;
  float lattice_conductance_;  ///< Σ w over a full lattice, the particle itself included, 1/m²
  float aggregate_factor_;     ///< how much too stiff pressure is by being flat in cells, per their
                               ///< size, 1/m
  std::uint32_t count_ = 0;    ///< cells
  CoarseView view_ = {};

  ScalarField active_;  ///< per particle: 1 or 0
  CellNeighbours neighbours_;
  Array<float> conductance_;  ///< slots per cell; in its own the operator's diagonal
  ScalarField inverse_diagonal_, pressure_, residual_, direction_, image_;  ///< per cell
  Kept<ConjugateGradients> iteration_;
  Array<std::uint32_t> nearest_, wet_cell_;  ///< per wet boundary sample
};

template <class F>
void CoarsePressure::solve(const StepContext& s, F error) {
  const CellGridView grid = s.grid;
  const BoundaryView solid = s.boundary;
  const float* active = active_.data();
  const std::uint32_t n = s.particles.count;
  const std::uint32_t* wet_cell = wet_cell_.data();
  const float volume = s.constants.volume;
  float *residual = residual_.data(), *pressure = pressure_.data(), *held_up = image_.data();
  s.executor.for_each("coarse pressure", count_, [=] SPINDRIFT_HD(std::uint32_t c) {
    Error sum{0, 0};
    for (std::uint32_t i = grid.cell_begin(c); i < grid.cell_begin(c + 1); ++i) {
      const Error e = error(i);
      sum.compression += active[i] * e.compression;
      sum.held_up += active[i] * e.held_up;
    }
    residual[c] = sum.compression;
    held_up[c] = sum.held_up;
  });
  const auto cell_of = [=] SPINDRIFT_HD(std::uint32_t k) { return wet_cell[k]; };
  s.executor.add_at_places("coarse pressure", solid.wet_count, residual, count_, cell_of,
                           [=] SPINDRIFT_HD(std::uint32_t k) {
                             return solid.position.value(solid.wet[k]) / volume *
                                    error(n + k).compression;
                           });
  s.executor.add_at_places("coarse pressure", solid.wet_count, held_up, count_, cell_of,
                           [=] SPINDRIFT_HD(std::uint32_t k) {
                             return solid.position.value(solid.wet[k]) / volume *
                                    error(n + k).held_up;
                           });
  s.executor.for_each("coarse pressure", count_, [=] SPINDRIFT_HD(std::uint32_t c) {
    residual[c] = std::max(residual[c], -held_up[c]);
  });
  conjugate_gradients(s.executor);
  const float scale = gain * aggregate_factor_ / s.map->inverse_cell * s.constants.rest_density /
                      (s.time_step * s.time_step);
  s.executor.for_each("coarse pressure", count_,
                      [=] SPINDRIFT_HD(std::uint32_t c) { pressure[c] *= scale; });
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
