#include "sim/forces/drag.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/core/from_glm.hpp"
#include "sim/core/lattice.hpp"
#include "sim/step/velocity_change.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

float DropDrag::flatness(float speed) const {
  const float weber_number = air_density * speed * speed * radius / tension;
  return std::min(1.f, weber_number / 12);
}

float DropDrag::coefficient(float speed, float flatness) const {
  const float reynolds_number = std::max(1e-3f, air_density * speed * 2 * radius / air_viscosity);
  const float of_ball = reynolds_number > 1000
                            ? 0.424f
                            : 24 / reynolds_number * (1 + std::pow(reynolds_number, 2.f / 3) / 6);
  return of_ball * (1 + 2.632f * flatness);
}

float DropDrag::area(float speed, float neighbours) const {
  const float in_liquid = std::min(1.f, neighbours / enough_neighbours);
  const float y = flatness(speed), across = radius * (1 + 0.5f * y);
  const float of_drop = coefficient(speed, y) * std::numbers::pi_v<float> * across * across;
  return (1 - in_liquid) * of_drop + in_liquid * spacing * spacing;
}

namespace {

/// Surface tension of water against air, N/m, for the drops of scenes that have no surface tension.
constexpr float tension_of_water = 0.0724f;

class Drag : public Force {
 public:
  Drag(const AirSettings& air, const FluidConstants& c) : velocity_(from_glm(air.velocity)) {
    int full = 0;
    for_lattice_points(c.spacing, c.support_radius, [&](const Vec3<float>&) { ++full; });
    drop_ = {.radius = std::cbrt(0.75f * c.volume / std::numbers::pi_v<float>),
             .air_density = air.density,
             .air_viscosity = air.viscosity,
             .tension = c.surface_tension > 0 ? c.surface_tension : tension_of_water,
             .spacing = c.spacing,
             .enough_neighbours = 2.f / 3 * static_cast<float>(full),
             .mass = c.rest_density * c.volume};
  }

  /// Implicit: the relative velocity is divided by 1 + its rate of decay times the kick, which is
  /// stable at every time step size.
  bool apply(const StepContext& s) override {
    const PointView x = s.particles.drifted_position.view(),
                    v = s.particles.drifted_velocity.view();
    const Vec3Arrays dv = s.particles.velocity_change().view();
    const StepView step = s.view();
    const DropDrag drop = drop_;
    const Vec3<float> air = velocity_;
    const float kick = s.kick;
    s.executor.for_each("drag", s.particles.count, [=] SPINDRIFT_HD(std::uint32_t i) {
      const Vec3<float> wind = air - v[i];
      const float speed = square_root(dot(wind, wind));
      if (step.is_held(i) || !(speed > 0)) {
        dv.set(i, {0, 0, 0});
        return;
      }
      const Vec3<float> upwind = (-1 / speed) * wind, xi = x[i];
      const float squared_radius = step.constants.support_radius * step.constants.support_radius;
      float near = 0, before = 0;
      step.neighbours.for_each(i, [&](std::uint32_t j) {
        const Vec3<float> d = x[j] - xi;
        const float squared = dot(d, d);
        if (!(squared < squared_radius) || !(squared > 0))
          return;
        near += 1;
        before = std::max(before, dot(d, upwind) / square_root(squared));
      });
      const float force =
          0.5f * drop.air_density * speed * drop.area(speed, near) * std::max(0.f, 1 - before);
      const float rate = kick * force / drop.mass;
      dv.set(i, (rate / (1 + rate)) * wind);
    });
    return change_velocities(s, "apply drag");
  }

  std::size_t memory_bytes() const override { return 0; }

 private:
  DropDrag drop_{};
  Vec3<float> velocity_;  ///< velocity of the air, m/s
};

}  // namespace

std::unique_ptr<Force> make_drag(const Settings& settings, const FluidConstants& constants) {
  const auto& air = settings.forces.air;
  return air ? std::make_unique<Drag>(*air, constants) : nullptr;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
