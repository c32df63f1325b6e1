// All that is solid in a run: the domain's walls and the obstacles, fixed or moving, both as
// boundary particles and as surfaces that stop particles.
#pragma once

#include <memory>
#include <vector>

#include "sim/boundary/boundary.hpp"
#include "sim/boundary/contact.hpp"
#include "sim/boundary/moving_bodies.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Changes the volume and `solid` of boundary particles of what is fixed, which a nozzle takes away
/// where it opens a wall. If the scene has moving obstacles, a change counts from the next call of
/// Walls::move() on.
struct SampleSetter {
  Boundary::Sample* of_moving;  ///< MovingBodies::samples(); null where nothing moves
  PointView samples;            ///< positions, m, with volumes, m³; used where nothing moves
  float* solid;                 ///< Boundary::solids(); used where nothing moves

  /// Sets the volume (m³) and `solid` of a boundary particle.
  /// @param b its index before the first call of Walls::move()
  SPINDRIFT_HD void set(std::uint32_t b, float new_volume, float new_solid) const {
    volume_of(b) = new_volume;
    solid_of(b) = new_solid;
  }
  /// Lessens the volume and `solid` of a boundary particle.
  /// @param b as in set()
  /// @param part the fraction of the volume that it keeps
  /// @param loss what its `solid` loses, as a density ratio
  SPINDRIFT_HD void lessen(std::uint32_t b, float part, float loss) const {
    volume_of(b) *= part;
    solid_of(b) -= loss;
  }

  SPINDRIFT_HD float& volume_of(std::uint32_t b) const {
    return of_moving != nullptr ? of_moving[b].volume : samples.value(b);
  }
  SPINDRIFT_HD float& solid_of(std::uint32_t b) const {
    return of_moving != nullptr ? of_moving[b].solid : solid[b];
  }
};

/// The boundary particles and the surfaces of all solids of a run.
class Walls {
 public:
  /// @param map the cells of all places where particles may be
  /// @param radius the support radius, m
  /// @throws Stopped
  Walls(const Settings& settings, const GridMap& map, float radius, Stop stop);

  /// All boundary particles; before the first call of move(), those of what is fixed alone.
  Boundary& boundary() { return boundary_; }
  const Boundary& boundary() const { return boundary_; }
  /// The surfaces of all solids, as last placed.
  ContactView contact() const;

  /// Whether any obstacle moves.
  bool any_moves() const { return moving_ != nullptr; }
  /// Places the moving obstacles where they are at the end of a step from `start` to `end`, s.
  void move(Executor& executor, double start, double end);
  /// The longest time step from a time (s) on, at most `longest` (s), in which no point of an
  /// obstacle moves farther than `distance`, m.
  double step_within(double distance, double time, double longest) const;

  SampleSetter sample_setter() {
    return {moving_ ? moving_->samples() : nullptr, boundary_.positions(), boundary_.solids()};
  }

  /// The present pressures of all boundary particles, Pa, in an order that does not depend on where
  /// they are.
  Copy<float> pressures(Executor& executor);
  /// Sets the pressures of all boundary particles, Pa, in the order of pressures().
  /// @throws std::invalid_argument if their number is not that of the boundary particles
  void set_pressures(const std::vector<float>& pressures);

  std::size_t memory_bytes() const;

 private:
  Settings fixed_;  ///< the settings without the moving obstacles
  Meshes meshes_;
  Boundary boundary_;
  Array<Solid> solids_;                   ///< the fixed obstacles
  std::unique_ptr<MovingBodies> moving_;  ///< null where nothing moves
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
