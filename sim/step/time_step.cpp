#include "sim/step/time_step.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace spindrift::sim {
namespace {

/// Largest ratio of a time step size to the size that the step before was allowed.
constexpr double growth = 1.3;

}  // namespace

TimeStepControl::TimeStepControl(const SolverSettings& settings, const FluidConstants& constants,
                                 float solver_limit)
    : settings_(settings),
      support_radius_(constants.support_radius),
      rest_density_(constants.rest_density),
      fixed_limit_(std::min(settings.max_time_step, solver_limit)) {}

double TimeStepControl::next(double remaining, double max_speed, double acceleration,
                             double pressure) {
  double limit = fixed_limit_;
  if (max_speed > 0)
    limit = std::min(limit, settings_.cfl * support_radius_ / max_speed);
  // A particle at rest must not be accelerated across a fraction of its support radius either
  // (Ihmsen et al. 2010).
  if (acceleration > 0)
    limit = std::min(limit, std::sqrt(settings_.cfl * support_radius_ / acceleration));
  // Pressure acts along the directions at the start of the step. Under high pressure, as at the
  // foot of a tall column, particles that turn around each other in a step are torn apart: their
  // frequency is √(p/ρ)/d, d the spacing.
  if (pressure > 0)
    limit = std::min(limit, 0.15 * support_radius_ / std::sqrt(pressure / rest_density_));
  if (allowed_ > 0)
    limit = std::min(limit, growth * allowed_);
  limit = std::max(limit, double{settings_.min_time_step});
  allowed_ = limit;
  // In single precision 5 ms are a little less, and must still divide 20 ms into four steps.
  constexpr double rounding = 1e-6;
  return remaining / std::ceil(remaining / limit * (1 - rounding));
}

void TimeStepControl::accepted(double time_step) {
  last_ = time_step;
}

double TimeStepControl::refused(double time_step) {
  const double smaller = 0.5 * time_step;
  allowed_ = smaller;
  if (smaller < settings_.min_time_step)
    throw std::runtime_error(fmt::format(
        "no time step down to solver.min_time_step = {:g} s keeps the compression within "
        "solver.max_compression and solver.mean_compression; raise those, or solver.max_iterations",
        settings_.min_time_step));
  return smaller;
}

void TimeStepControl::resume(double last, double allowed) {
  last_ = last;
  allowed_ = allowed;
}

Vec3<float> body_acceleration(const ForceSettings& forces, double time) {
  glm::vec3 a = forces.gravity;
  const auto& keys = forces.body;
  if (!keys.empty()) {
    const auto after = std::find_if(keys.begin(), keys.end(),
                                    [&](const AccelerationKey& k) { return k.time > time; });
    if (after == keys.begin()) {
      a += keys.front().acceleration;
    } else if (after == keys.end()) {
      a += keys.back().acceleration;
    } else {
      const auto before = after - 1;
      const auto f = static_cast<float>((time - before->time) / (after->time - before->time));
      a += glm::mix(before->acceleration, after->acceleration, f);
    }
  }
  return {a.x, a.y, a.z};
}

}  // namespace spindrift::sim
