#include "sim/forces/surface_tension.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/step/velocity_change.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

/// The factors of the forces; the arrays are still to be set.
TensionView view_of(const FluidConstants& c) {
  const TensionKernel kernel(c.spacing, c.support_radius);
  const double slope = -6. * kernel.scale * kernel.inverse_squared_radius;  // w'(r)/r at r = 0
  const double mass = double{c.rest_density} * c.volume;
  const double surface = double{c.surface_tension} * c.spacing * c.spacing;  // J
  const double factor = 2 * SurfaceTension::lack_weight * slope * surface / mass;
  const double cos_angle = std::cos(double{c.contact_angle} * std::numbers::pi / 180);
  const double wetting = 1 - std::sqrt(std::max(0., -cos_angle));
  return {
      .kernel = kernel,
      .factor = static_cast<float>(factor),
      .gradient_factor = SurfaceTension::gradient_weight / SurfaceTension::lack_weight * c.spacing,
      .wetting = static_cast<float>(wetting / c.volume),
      .lack = nullptr,
      .gradient = {}};
}

}  // namespace

SurfaceTension::SurfaceTension(const FluidConstants& c)
    : time_step_limit_(
          0.3f * std::sqrt(c.rest_density * c.spacing * c.spacing * c.spacing / c.surface_tension)),
      view_(view_of(c)) {}

std::unique_ptr<Force> make_surface_tension(const Settings&, const FluidConstants& constants) {
  return constants.surface_tension > 0 ? std::make_unique<SurfaceTension>(constants) : nullptr;
}

bool SurfaceTension::apply(const StepContext& s) {
  Particles& p = s.particles;
  const std::uint32_t n = p.count;
  view_.lack = lack_.resized(n);
  gradient_.resize(n);
  view_.gradient = gradient_.view();
  const PointView x = p.drifted_position.view();
  const Vec3Arrays dv = p.velocity_change().view();
  const StepView step = s.view();
  const TensionView view = view_;
  const float kick = s.kick;
  s.executor.for_each("surface tension", n, [=] SPINDRIFT_HD(std::uint32_t i) {
    const Colour<float> c = colour(i, step.constants, view, x, step.neighbours, step.boundary);
    view.lack[i] = std::max(0.f, 1 - c.value);
    view.gradient.set(i, c.gradient);
  });
  s.executor.for_each("surface tension", n, [=] SPINDRIFT_HD(std::uint32_t i) {
    dv.set(i, step.is_held(i)
                  ? Vec3<float>{0, 0, 0}
                  : kick * tension_acceleration(i, view, x, step.neighbours, step.boundary));
  });
  return change_velocities(s, "apply surface tension");
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
