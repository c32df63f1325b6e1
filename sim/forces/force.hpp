// Forces that act before pressure, as the step sees them.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class Force {
 public:
  virtual ~Force() = default;

  /// Changes the drifted velocities and positions (change_velocities() does so). Returns true if it
  /// moved a particle so far that its neighbours are no longer those that are listed.
  virtual bool apply(const StepContext& step) = 0;

  /// The longest step in which it is stable, s.
  virtual float time_step_limit() const { return std::numeric_limits<float>::infinity(); }

  /// Of the fields that the force keeps, bytes.
  virtual std::size_t memory_bytes() const = 0;
};

/// The forces that a scene has, in the order in which they are applied; it pays for no other.
std::vector<std::unique_ptr<Force>> forces_of(const Settings& settings,
                                              const FluidConstants& constants);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
