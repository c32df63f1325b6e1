// Viscosity, explicit where the time step size is small enough for that, implicit where it is not.
// Both use the same operator, so that a scene looks the same with either.
#pragma once

#include "sim/core/conjugate_gradients.hpp"
#include "sim/forces/force.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class Viscosity : public Force {
 public:
  /// @param wall_viscosity the largest wall viscosity of any wall or obstacle, Pa·s
  Viscosity(const FluidConstants& constants, float wall_viscosity);

  bool apply(const StepContext& s) override;

  // Parts of apply(), which leave the velocity changes in Particles::velocity_change(). They are
  // public since CUDA allows no device lambdas in private functions.
  void explicit_step(const StepContext& s);
  void implicit_step(const StepContext& s);

  std::size_t memory_bytes() const override {
    return residual_.memory_bytes() + image_.memory_bytes();
  }

 private:
  float support_radius_;  ///< H, m
  DiffusionKernel kernel_;
  double explicit_limit_;  ///< largest stable explicit time step, s
  // State of the implicit step's conjugate gradient iteration; the fields are empty until needed.
  VectorField residual_, image_;
  Kept<ConjugateGradients> iteration_;
};

/// The viscosity of a scene; null where neither the liquid nor any wall or obstacle has one.
std::unique_ptr<Force> make_viscosity(const Settings& settings, const FluidConstants& constants);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
