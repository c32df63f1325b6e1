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

#include <array>
#include <vector>

#include "sim/backend.hpp"
#include "sim/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class CoarsePressure {
 public:
  explicit CoarsePressure(const FluidConstants& constants);

  /// Finds the cells' neighbours and conductances for the particles as they are, of which those
  /// count that are under pressure or nearly dense enough for it.
  /// @param delta pressure per density ratio, δ, Pa
  void build(const StepContext& s, float delta);

  /// The pressure per cell, Pa, that takes away the residuals: residual(k) is ρ/ρ₀ − 1 of particle
  /// k for k < count, then of the wet boundary samples.
  template <class F>
  void solve(const StepContext& s, F residual);

  /// f(i, pressure at particle i, Pa) for all particles of a cell.
  template <class F>
  void at_particles(const StepContext& s, std::uint32_t cell, F f) const;
  /// Pressure at the wet boundary sample k, Pa: that of the particle nearest to it.
  float at_wall(const StepContext& s, std::uint32_t k) const {
    return at(s.particles.drifted_position.view()[nearest_[k]], pressures_around(wet_cell_[k]));
  }
  std::size_t memory_bytes() const;

 private:
  static constexpr int slots = CellNeighbourView::slots, self = CellNeighbourView::self;
  /// Of a cell and those around it, Pa; its own where there is none.
  using Around = std::array<float, slots>;

  /// Part of the solution that is applied. Pressure outlasts the step in the warm start, and with
  /// more than about 1.15 times what is needed the steps would swing from one side to the other.
  static constexpr float gain = 0.45f;

  void find_active(const StepContext& s, float delta);
  void connect(const StepContext& s, std::uint32_t cell);
  float conductance_between(const StepContext& s, std::uint32_t a, std::uint32_t b) const;
  float conductance_to_walls(const StepContext& s, std::uint32_t cell) const;
  void attach_walls(const StepContext& s);
  void conjugate_gradients(Executor& executor);
  Around pressures_around(std::uint32_t cell) const;
  template <class Real>
  Real at(const Vec3<Real>& x, const Around& around) const;

  GridMap map_;
  ConductanceKernel kernel_;
  float lattice_conductance_;  ///< Σ w over a full lattice, the particle itself included, 1/m²
  float aggregate_factor_;     ///< how much too stiff pressure is by being flat in cells, per their
                               ///< size, 1/m
  std::uint32_t count_ = 0;    ///< cells

  ScalarField active_;  ///< per particle: 1 or 0
  CellNeighbours neighbours_;
  std::vector<float> conductance_;  ///< slots per cell; in its own the operator's diagonal
  ScalarField inverse_diagonal_, pressure_, residual_, direction_, image_;  ///< per cell
  std::vector<std::uint32_t> nearest_, wet_cell_;  ///< per wet boundary sample
};

template <class F>
void CoarsePressure::solve(const StepContext& s, F residual) {
  const CellGrid& grid = *s.grid;
  s.executor.for_each("coarse pressure", count_, [&](std::uint32_t c) {
    float sum = 0;
    for (std::uint32_t i = grid.cell_begin(c); i < grid.cell_begin(c + 1); ++i)
      sum += active_[i] * residual(i);
    residual_[c] = sum;
  });
  for (std::uint32_t k = 0; k < s.boundary.wet_count; ++k)
    residual_[wet_cell_[k]] +=
        s.boundary.volume[s.boundary.wet[k]] / s.constants.volume * residual(s.particles.count + k);
  conjugate_gradients(s.executor);
  const float scale = gain * aggregate_factor_ / map_.inverse_cell * s.constants.rest_density /
                      (s.time_step * s.time_step);
  for (std::uint32_t c = 0; c < count_; ++c)
    pressure_[c] *= scale;
}

/// Weights of the three cells around by the quadratic B-spline; `place` in cells.
template <class Real>
std::array<Real, 3> spline_weights(Real place) {
  const Real t = place - rounded_down(place) - 0.5f;
  return {0.5f * (0.5f - t) * (0.5f - t), 0.75f - t * t, 0.5f * (0.5f + t) * (0.5f + t)};
}

template <class Real>
Real CoarsePressure::at(const Vec3<Real>& x, const Around& around) const {
  const auto wx = spline_weights((x.x - map_.origin.x) * map_.inverse_cell);
  const auto wy = spline_weights((x.y - map_.origin.y) * map_.inverse_cell);
  const auto wz = spline_weights((x.z - map_.origin.z) * map_.inverse_cell);
  Real sum{};
  for (std::size_t k = 0, t = 0; k < 3; ++k)
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < 3; ++i, ++t)
        sum += wx[i] * wy[j] * wz[k] * around[t];
  return sum;
}

template <class F>
void CoarsePressure::at_particles(const StepContext& s, std::uint32_t cell, F f) const {
  const Vec3Arrays x = s.particles.drifted_position.view();
  const Around around = pressures_around(cell);
  const std::uint32_t end = s.grid->cell_begin(cell + 1);
  for (std::uint32_t i = s.grid->cell_begin(cell); i < end; i += lane_count) {
    const Lanes p =
        at(Vec3<Lanes>{consecutive(x.x + i), consecutive(x.y + i), consecutive(x.z + i)}, around);
    for (std::uint32_t k = 0; k < lane_count && i + k < end; ++k)
      f(i + k, p[k]);
  }
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
