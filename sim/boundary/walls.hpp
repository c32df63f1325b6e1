// All that is solid: the domain's walls, and obstacles, fixed or moving; as samples with volume,
// and as surfaces that stop particles.
#pragma once

#include <memory>
#include <vector>

#include "sim/boundary/boundary.hpp"
#include "sim/boundary/contact.hpp"
#include "sim/boundary/moving_bodies.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

/// Changes how much a sample of what is fixed stands for: nothing where a nozzle opens the wall.
/// Where anything moves, from the next time on that samples are put where they are.
struct SampleSetter {
  Boundary::Sample* of_moving;  ///< null where nothing moves
  PointView samples;            ///< with their volumes
  float* solid;

  /// @param b its number before Walls::move() was called first
  SPINDRIFT_HD void set(std::uint32_t b, float new_volume, float new_solid) const {
    volume_of(b) = new_volume;
    solid_of(b) = new_solid;
  }
  /// @param part of the volume that it keeps @param loss of density ratio that the solid makes up
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

class Walls {
 public:
  /// @param map of all places where particles may be @param radius the support radius, m
  /// @throws Stopped
  Walls(const Settings& settings, const GridMap& map, float radius, Stop stop);

  /// Until move() is called first: the samples of what is fixed.
  Boundary& boundary() { return boundary_; }
  const Boundary& boundary() const { return boundary_; }
  ContactView contact() const;

  /// Whether anything moves.
  bool move() const { return moving_ != nullptr; }
  /// Puts what moves where it is at the end of a step, s.
  void move(Executor& executor, double start, double end);
  /// As MovingBodies::step_within.
  double step_within(double distance, double time, double longest) const;

  SampleSetter sample_setter() {
    return {moving_ ? moving_->samples() : nullptr, boundary_.positions(), boundary_.solids()};
  }

  /// Pressures of all samples as they are now, in an order that does not depend on where those
  /// are, Pa.
  Copy<float> pressures(Executor& executor);
  /// @throws std::invalid_argument where these are not so many
  void set_pressures(const std::vector<float>& pressures);

  std::size_t memory_bytes() const;

 private:
  Settings fixed_;  ///< without the obstacles that move
  Meshes meshes_;
  Boundary boundary_;
  Array<Solid> solids_;                   ///< what is fixed, but for the domain
  std::unique_ptr<MovingBodies> moving_;  ///< null where nothing moves
};

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
