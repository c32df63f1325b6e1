// The interface of the forces that a time step applies before pressure: surface tension, drag and
// viscosity.
#pragma once

#include <limits>
#include <memory>
#include <vector>

#include "sim/step/solver.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class Force {
 public:
  virtual ~Force() = default;

  /// Changes the drifted velocities and positions, by way of change_velocities().
  /// @return whether it moved any particle so far that neighbours must be listed anew
  virtual bool apply(const StepContext& step) = 0;

  /// The largest time step size at which the force is stable, s.
  virtual float time_step_limit() const { return std::numeric_limits<float>::infinity(); }

  /// Memory of the fields that the force keeps, bytes.
  virtual std::size_t memory_bytes() const = 0;
};

/// The forces that a scene has, in the order in which they are applied. A scene does not pay for
/// those that it lacks.
std::vector<std::unique_ptr<Force>> forces_of(const Settings& settings,
                                              const FluidConstants& constants);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
