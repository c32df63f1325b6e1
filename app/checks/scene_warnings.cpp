#include "app/checks/scene_warnings.hpp"

#include <fmt/format.h>

#include <cmath>

#include "app/checks/estimate.hpp"
#include "app/checks/scene_meshes.hpp"
#include "app/errors/error_report.hpp"
#include "app/errors/shown_text.hpp"
#include "app/tables/document.hpp"
#include "sim/boundary/obstacle_motion.hpp"
#include "sim/flow/nozzle.hpp"
#include "sim/geometry/shape.hpp"
#include "sim/start/fill.hpp"
#include "sim/start/initial.hpp"
#include "sim/start/standing_bodies.hpp"

namespace spindrift::app {
namespace {

constexpr double told_from = 0.01;  // least part of a volume's liquid that is worth a warning

/// Collects the warnings of a scene, but for those of its meshes.
class Warnings {
 public:
  explicit Warnings(const Scene& scene) : scene_(scene), settings_(scene.simulation) {}

  std::vector<Diagnostic> take() {
    look_at_volumes();
    look_at_obstacles();
    for (std::size_t i = 0; i < settings_.fluid.emitters.size(); ++i)
      look_at_emitter(settings_.fluid.emitters[i], child_path("fluid.emitters", i));
    look_at_speed_of_sound();
    return std::move(found_);
  }

 private:
  void add(const std::string& path, const std::string& message) {
    found_.push_back({path, message});
  }

  void look_at_volumes() {
    if (!is_cheap_to_fill(settings_))
      return;
    const double each = std::pow(double{sim::particle_spacing(settings_)}, 3);
    const std::vector<sim::FilledVolume> filled = sim::count_volumes(settings_);
    for (std::size_t i = 0; i < filled.size(); ++i)
      look_at_volume(filled[i], each, i);
  }

  /// @param each volume of one particle, m³
  void look_at_volume(const sim::FilledVolume& filled, double each, std::size_t number) {
    const std::string path = child_path("fluid.volumes", number);
    const sim::Shape& shape = settings_.fluid.volumes[number].shape;
    const double asked = sim::volume_of(shape);
    auto all = static_cast<double>(filled.placed + filled.outside);
    for (const auto& [k, count] : filled.in_obstacles) {
      const auto left_out = static_cast<double>(count);
      all += left_out;
      if (left_out * each > told_from * asked) {
        add(path, fmt::format("{} of its {} litres are in obstacles[{}] and left out",
                              litres_text(left_out * each), litres_text(asked), k));
      }
    }
    if (static_cast<double>(filled.outside) * each > told_from * asked) {
      add(path,
          fmt::format("{} of its {} litres are outside the domain and left out",
                      litres_text(static_cast<double>(filled.outside) * each), litres_text(asked)));
    }
    if (std::abs(all * each - asked) > told_from * asked) {
      add(path, fmt::format("{} litres are asked for, {} fit particles {:g} m apart; a smaller "
                            "fluid.spacing comes nearer",
                            litres_text(asked), litres_text(all * each), settings_.fluid.spacing));
    }
  }

  /// Warns of a low speed of sound. The equation of state lets the liquid be compressed by about
  /// (v/c)², where v is the fastest speed of the scene and c the speed of sound (Monaghan 1994).
  void look_at_speed_of_sound() {
    const float given = settings_.solver.speed_of_sound;
    if (settings_.solver.type != sim::SolverType::sph || given <= 0)
      return;
    const float enough = sim::default_speed_of_sound(settings_);
    if (given < 0.999f * enough) {
      add("solver.speed_of_sound",
          fmt::format(
              "{:g} m/s is less than ten times the {:g} m/s that the liquid can reach in "
              "this scene: it may be compressed by more than 1 %; from {:g} m/s on, or with "
              "0, it is not",
              given, enough / 10, enough));
    }
  }

  void look_at_obstacles() {
    for (std::size_t k = 0; k < settings_.obstacles.size(); ++k)
      if (!ever_in_domain(settings_.obstacles[k]))
        add(child_path("obstacles", k), "is outside the domain all the time, where no liquid is");
  }

  bool ever_in_domain(const sim::Obstacle& obstacle) const {
    const sim::Box domain{settings_.domain.min, settings_.domain.max};
    const sim::Box bounds = sim::bounds_of(obstacle.shape);
    if (!obstacle.motion)
      return !sim::is_apart(bounds, domain);
    for (int frame = 0; frame <= scene_.video.frame_count(); ++frame) {
      const double time = scene_.video.frames_per_second.time_of(frame);
      if (!sim::is_apart(sim::bounds_at(sim::pose_at(obstacle, time), bounds), domain))
        return true;
    }
    return false;
  }

  void look_at_emitter(const sim::Emitter& emitter, const std::string& path) {
    const float spacing = sim::particle_spacing(settings_);
    const sim::Nozzle nozzle(emitter, spacing);
    const double end = scene_.video.duration;
    if (nozzle.released(end) == 0) {
      add(path, fmt::format("brings nothing: its first liquid comes out at {:.3g} s, and the end "
                            "is at {:.3g} s",
                            nozzle.release_time(0), end));
      return;
    }
    // Particles enter the nozzle at the end behind the opening, where there must be room.
    const sim::StandingBodies bodies(settings_);
    const double entry = nozzle.entry_time(nozzle.layer_count() - 1);
    std::vector<std::size_t> taken(settings_.fluid.volumes.size());
    for (std::uint32_t point = 0; point < nozzle.layer_size(); ++point) {
      const glm::vec3 p = nozzle.position(nozzle.layer_count() - 1, point, entry);
      if (bodies.part_inside(p, glm::vec3(spacing)).inside > 0.5)
        continue;
      for (std::size_t k = 0; k < taken.size(); ++k)
        taken[k] += sim::is_inside(settings_.fluid.volumes[k].shape, p);
    }
    for (std::size_t k = 0; k < taken.size(); ++k) {
      if (2 * taken[k] > nozzle.layer_size()) {
        add(path, fmt::format("its nozzle, four spacings behind the opening, is in "
                              "fluid.volumes[{}]: it brings nothing while liquid is there",
                              k));
        return;
      }
    }
  }

  const Scene& scene_;
  const sim::Settings& settings_;
  std::vector<Diagnostic> found_;
};

}  // namespace

std::vector<Diagnostic> warnings_of(const Scene& scene) {
  std::vector<Diagnostic> found = mesh_warnings(scene);
  for (Diagnostic& warning : Warnings(scene).take())
    found.push_back(std::move(warning));
  return found;
}

void print_warnings(const Scene& scene) {
  for (const Diagnostic& warning : warnings_of(scene))
    tell_warning(fmt::format("{}: {}", warning.path, warning.message));
}

}  // namespace spindrift::app
