// A pressure correction on a coarse grid, which the PCISPH solver adds to the first iteration of a
// step. An iteration over particles carries pressure one support radius on; a column of a hundred
// particles would need a hundred iterations to feel its own weight. On the grid of the neighbour
// search's cells, with nine times fewer unknowns, the same equation is solved across the whole
// liquid at once.
//
// The cells are aggregates of their particles: pressure is one number per cell, and a cell's
// residual is the sum of its particles'. In ∇²p = Σⱼ wᵢⱼ (pⱼ − pᵢ) two particles have a conductance
// wᵢⱼ between them; between cells it is the sum over their pairs. What a particle's neighbourhood
// lacks counts as free surface, where pressure is zero. The solution is interpolated by quadratic
// B-splines, which leave no kinks for the particles to mend.
#pragma once

#include <algorithm>
#include <array>

#include "sim/backend/backend.hpp"
#include "sim/core/conjugate_gradients.hpp"
#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Weights of the quadratic B-spline for the three cells around a point, along one axis.
/// @param place the point's coordinate, in cells
template <class Real>
SPINDRIFT_HD std::array<Real, 3> spline_weights(Real place) {
  const Real t = place - rounded_down(place) - 0.5f;
  return {0.5f * (0.5f - t) * (0.5f - t), 0.75f - t * t, 0.5f * (0.5f + t) * (0.5f + t)};
}

/// The solution of the coarse grid, as loops over particles see it.
struct CoarseView {
  GridMap map;
  CellGridView grid;
  CellNeighbourView neighbours;
  PointView position;     ///< positions of the particles, m
  const float* pressure;  ///< pressure per cell, Pa
  /// Per wet boundary particle: the nearest fluid particle, and that particle's cell.
  const std::uint32_t *nearest, *wet_cell;

  /// Calls f(i, p) for all particles i of a cell, with the interpolated pressure p, Pa.
  template <class F>
  SPINDRIFT_HD void at_particles(std::uint32_t cell, F f) const {
    const Around around = pressures_around(cell);
    for_run(
        grid.cell_begin(cell), grid.cell_begin(cell + 1),
        [&](auto i) { return at(position[i], around); }, f);
  }
  /// Pressure at the k-th wet boundary particle, Pa: that of the fluid particle nearest to it.
  SPINDRIFT_HD float at_wall(std::uint32_t k) const {
    return at(position[nearest[k]], pressures_around(wet_cell[k]));
  }

 private:
  /// Pressures of a cell and of those around it, Pa; its own in place of cells that are empty.
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

/// The linear system of the coarse grid, A p = r, as loops over its cells see it.
struct CoarseSystem {
  std::uint32_t count;  ///< number of cells
  CellNeighbourView neighbours;
  /// The matrix A, 1/m²: the conductances between each cell and the 26 around it, by slot
  /// (CellNeighbourView::place); a cell's own slot holds the diagonal.
  float* conductance;
  float* inverse_diagonal;  ///< m²
  float *pressure, *residual;
  float *direction, *image;  ///< of the conjugate gradients
};

/// Solves for the pressures by conjugate gradients, with the diagonal as preconditioner, until a
/// hundredth of the residual is left.
void solve(Executor& executor, const CoarseSystem& system, Kept<ConjugateGradients>& iteration);

/// The coarse grid's operator and its solver.
class CoarsePressure {
 public:
  explicit CoarsePressure(const FluidConstants& constants);

  /// Finds the cells' neighbours and conductances for the drifted positions. Only particles that
  /// are under pressure, or nearly dense enough for it, count.
  /// @param delta pressure per density ratio, δ, Pa
  void build(const StepContext& s, float delta);

  /// The error at a fluid particle or a wet boundary particle, in density ratios.
  struct Error {
    float compression;  ///< ρ/ρ₀ less the wanted value
    float held_up;      ///< how far pressure can hold ρ/ρ₀ below the wanted value, p/δ
  };

  /// Finds the pressure per cell, Pa, that takes away the errors. A cell's errors are added up with
  /// their signs, and only their sum is bounded by the pressure that there is: else the scatter of
  /// single particles would look like compression of the whole, and throw a tall column up.
  /// @param error error(k) is the Error of unknown k: first come the fluid particles, then the wet
  ///              boundary particles
  template <class F>
  void solve(const StepContext& s, F error);

  /// The solution, for the particles of the last build().
  CoarseView view() const { return view_; }

  std::size_t memory_bytes() const;

 private:
  /// Share of the solution that is applied. Pressure outlasts the step in the warm start, so that
  /// with much more the steps swing from one side to the other.
  static constexpr float gain = 0.3f;

  CoarseSystem system() {
    return {count_,           neighbours_.view(), conductance_.data(), inverse_diagonal_.data(),
            pressure_.data(), residual_.data(),   direction_.data(),   image_.data()};
  }

  ConductanceKernel kernel_;
  float lattice_conductance_;  ///< Σ w over a full lattice, the particle itself included, 1/m²
  float aggregate_factor_;     ///< how much too stiff the operator is since pressure is flat within
                               ///< cells, per cell size, 1/m
  std::uint32_t count_ = 0;    ///< number of cells
  CoarseView view_ = {};

  ScalarField active_;  ///< 1 for each particle that counts, else 0
  CellNeighbours neighbours_;
  Array<float> conductance_;                                                ///< as in CoarseSystem
  ScalarField inverse_diagonal_, pressure_, residual_, direction_, image_;  ///< one value per cell
  Kept<ConjugateGradients> iteration_;
  Array<std::uint32_t> nearest_, wet_cell_;  ///< as in CoarseView
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
  sim::SPINDRIFT_BACKEND::solve(s.executor, system(), iteration_);
  const float scale = gain * aggregate_factor_ / s.map->inverse_cell * s.constants.rest_density /
                      (s.time_step() * s.time_step());
  s.executor.for_each("coarse pressure", count_,
                      [=] SPINDRIFT_HD(std::uint32_t c) { pressure[c] *= scale; });
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
