#include "app/scene_warnings.hpp"

#include <fmt/format.h>

#include "sim/initial.hpp"

namespace spindrift::app {
namespace {

/// The equation of state lets the liquid be compressed by about (v/c)²: v is the fastest speed of
/// the scene, c the speed of sound (Monaghan 1994).
void warn_of_slow_sound(const sim::Settings& settings, std::vector<std::string>& warnings) {
  const float given = settings.solver.speed_of_sound;
  if (settings.solver.type != sim::SolverType::sph || given <= 0)
    return;
  sim::InitialParticles start;
  for (const sim::Volume& volume : settings.fluid.volumes)
    start.velocities.push_back(volume.velocity);
  const float enough = sim::default_speed_of_sound(settings, start);
  if (given < 0.999f * enough)
    warnings.push_back(fmt::format(
        "solver.speed_of_sound: {:g} m/s is less than ten times the {:g} m/s that the liquid can "
        "reach in this scene: it may be compressed by more than 1 %; from {:g} m/s on, or with 0, "
        "it "
        "is not",
        given, enough / 10, enough));
}

}  // namespace

std::vector<std::string> scene_warnings(const Scene& scene) {
  std::vector<std::string> warnings;
  warn_of_slow_sound(scene.simulation, warnings);
  return warnings;
}

}  // namespace spindrift::app
