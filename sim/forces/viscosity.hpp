// Viscosity, explicit where a step is short enough for that, implicit where it is not. Both use the
// same operator, so that what a scene looks like does not depend on which it is.
#pragma once

#include "sim/core/conjugate_gradients.hpp"
#include "sim/forces/force.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class Viscosity : public Force {
 public:
  /// @param wall_viscosity the largest of any wall, Pa·s
  Viscosity(const FluidConstants& constants, float wall_viscosity);

  bool apply(const StepContext& s) override;

  // The two ways to do it; public since CUDA has no loops in private functions.
  void explicit_step(const StepContext& s);
  void implicit_step(const StepContext& s);

  std::size_t memory_bytes() const override {
    return residual_.memory_bytes() + image_.memory_bytes();
  }

 private:
  float support_radius_;  ///< H, m
  DiffusionKernel kernel_;
  double explicit_limit_;  ///< largest stable explicit time step, s
  // Of the implicit step, which is a conjugate gradient iteration; empty until it is needed.
  VectorField residual_, image_;
  Kept<ConjugateGradients> iteration_;
};

/// None where neither the liquid nor any wall holds it back.
std::unique_ptr<Force> make_viscosity(const Settings& settings, const FluidConstants& constants);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
