#include "app/checks/scene_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <variant>

#include "app/checks/estimate.hpp"
#include "app/checks/exchange_checks.hpp"
#include "app/errors/shown_text.hpp"
#include "app/scene/scene_fields.hpp"
#include "sim/flow/nozzle.hpp"
#include "sim/geometry/shape.hpp"
#include "sim/start/initial.hpp"

namespace spindrift::app {
namespace {

constexpr double most_particles = 2e8;
constexpr float most_spacings_from_origin = 1e5f;  // beyond, single precision is too coarse
constexpr std::size_t longest_scene_name = 200;  // bytes; names of files made from it may have 255

class Checker {
 public:
  Checker(const Scene& scene, const SceneDocument& document) : scene_(scene), document_(document) {}

  /// Returns all problems of the scene.
  std::vector<Problem> check() {
    check_domain();
    check_obstacles();
    check_volumes();
    check_sinks();
    if (problems_.empty()) {  // otherwise there may be no liquid to check, or far too much
      check_liquid();
      check_emitters();
    }
    check_name();
    check_forces_and_solver();
    check_picture();
    check_probes();
    check_camera();
    return std::move(problems_);
  }

 private:
  void complain(const std::string& path, const std::string& message) {
    problems_.push_back(document_.problem(path, message));
  }

  void check_name() {
    const std::string& name = scene_.name;
    const bool given = document_.root().contains("name");
    const auto refuse = [&](std::string_view why) {
      complain("name", fmt::format("\"{}\"{} can't name a folder{}{}", shown(name),
                                   given ? "" : ", the file's name,", why,
                                   given ? "" : "; give a \"name\""));
    };
    if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos)
      refuse("");
    else if (holds_control_characters(name))
      refuse(": it holds control characters");
    else if (name.size() > longest_scene_name)
      refuse(
          fmt::format(": it has {} bytes; accepted: at most {}", name.size(), longest_scene_name));
  }

  void check_shape(const sim::Shape& shape, const std::string& path) {
    if (const std::string problem = sim::problem_of(shape); !problem.empty())
      complain(child_path(path, sim::name_of(shape)), problem);
  }

  void check_domain() {
    const auto& domain = scene_.simulation.domain;
    const float spacing = scene_.simulation.fluid.spacing;
    if (const auto problem = sim::Box{domain.min, domain.max}.problem(); !problem.empty())
      return complain("domain", problem);
    for (int axis = 0; axis < 3; ++axis) {
      const float width = domain.max[axis] - domain.min[axis];
      if (width < 4.f * spacing * 0.999f) {
        return complain("domain",
                        fmt::format("{:g} m wide in {}; at least 4 particle spacings ({:g} m) are "
                                    "needed",
                                    width, "xyz"[axis], 4.f * spacing));
      }
      const float reach = std::max(std::abs(domain.min[axis]), std::abs(domain.max[axis]));
      if (reach > most_spacings_from_origin * spacing) {
        return complain("domain",
                        fmt::format("reaches {:g} m from the origin in {}; at most {:.0f} particle "
                                    "spacings ({:g} m) are accepted",
                                    reach, "xyz"[axis], most_spacings_from_origin,
                                    most_spacings_from_origin * spacing));
      }
    }
  }

  void check_obstacles() {
    const auto& obstacles = scene_.simulation.obstacles;
    for (std::size_t i = 0; i < obstacles.size(); ++i) {
      const std::string path = child_path("obstacles", i);
      check_shape(obstacles[i].shape, path);
      if (obstacles[i].motion)
        check_motion(*obstacles[i].motion, child_path(path, "motion"));
    }
  }

  void check_motion(const sim::Motion& motion, const std::string& path) {
    if (motion.keyframes.empty() && motion.oscillations.empty() && !motion.spin) {
      complain(path,
               "says nothing of how the obstacle moves; give keyframes, oscillations or spin");
    }
    check_times(motion.keyframes, child_path(path, "keyframes"));
    for (std::size_t i = 0; i < motion.oscillations.size(); ++i) {
      const sim::Oscillation& one = motion.oscillations[i];
      if (one.translate == glm::vec3(0.f) && one.rotate == glm::vec3(0.f)) {
        complain(child_path(child_path(path, "oscillations"), i),
                 "has no amplitude; give translate (m) or rotate (degrees)");
      }
    }
    if (motion.spin && !(glm::length(motion.spin->axis) > 1e-6f))
      complain(child_path(child_path(path, "spin"), "axis"), "has no length");
  }

  void check_volumes() {
    const auto& fluid = scene_.simulation.fluid;
    if (fluid.volumes.empty() && fluid.emitters.empty()) {
      complain("fluid.volumes",
               "empty; at least one volume of liquid or one of fluid.emitters is needed");
    }
    const double cell = std::pow(static_cast<double>(fluid.spacing), 3);
    double count = 0.;
    for (std::size_t i = 0; i < fluid.volumes.size(); ++i) {
      check_shape(fluid.volumes[i].shape, child_path("fluid.volumes", i));
      check_place(fluid.volumes[i].shape, child_path("fluid.volumes", i));
      count += sim::volume_of(fluid.volumes[i].shape) / cell;
    }
    for (const sim::Emitter& emitter : fluid.emitters) {
      const double until = std::min(static_cast<double>(emitter.to), scene_.video.duration);
      const double time = std::max(0., until - emitter.from);
      double more = sim::opening_area(emitter.opening) * emitter.speed * time / cell;
      if (emitter.max_particles > 0)
        more = std::min(more, static_cast<double>(emitter.max_particles));
      count += more;
    }
    if (count > most_particles) {
      complain("fluid.spacing",
               fmt::format("{:g} m makes about {:.2g} particles; at most {:.0e} are "
                           "accepted",
                           fluid.spacing, count, most_particles));
    }
    const double on_walls = count_boundary_particles(scene_.simulation);
    if (on_walls > most_particles) {
      complain(
          "fluid.spacing",
          fmt::format("{:g} m makes about {:.2g} particles on walls and obstacles; at most {:.0e} "
                      "are accepted",
                      fluid.spacing, on_walls, most_particles));
    }
  }

  /// Checks that a volume of liquid is inside the domain. It may reach half a spacing beyond, since
  /// no particle would be placed there.
  void check_place(const sim::Shape& shape, const std::string& path) {
    const auto& domain = scene_.simulation.domain;
    const sim::Box bounds = sim::bounds_of(shape);
    if (!glm::all(glm::lessThan(domain.min, domain.max)))
      return;  // an empty domain is reported by check_domain
    const float tolerance = 0.501f * scene_.simulation.fluid.spacing;
    if (glm::any(glm::lessThan(bounds.min, domain.min - tolerance)) ||
        glm::any(glm::greaterThan(bounds.max, domain.max + tolerance))) {
      complain(path, fmt::format("{} litres from {} to {}, which is outside the domain {} ... {}",
                                 litres_text(sim::volume_of(shape)), vector_text(bounds.min),
                                 vector_text(bounds.max), vector_text(domain.min),
                                 vector_text(domain.max)));
    }
  }

  /// Checks that every volume has at least one particle outside of obstacles.
  void check_liquid() {
    const sim::Settings& settings = scene_.simulation;
    if (!is_cheap_to_fill(settings))
      return;
    const std::vector<sim::FilledVolume> filled = sim::count_volumes(settings);
    for (std::size_t i = 0; i < filled.size(); ++i) {
      if (filled[i].placed > 0)
        continue;
      const std::string path = child_path("fluid.volumes", i);
      const auto& inside = filled[i].in_obstacles;
      const auto most =
          std::max_element(inside.begin(), inside.end(),
                           [](const auto& a, const auto& b) { return a.second < b.second; });
      if (most != inside.end()) {
        complain(path, fmt::format("all of its {} litres are inside obstacles[{}]{}; move either, "
                                   "or leave one out",
                                   litres_text(sim::volume_of(settings.fluid.volumes[i].shape)),
                                   most->first, hint_of(settings, most->first)));
      } else {
        complain(path,
                 fmt::format("holds no particle at a spacing of {:g} m", settings.fluid.spacing));
      }
    }
  }

  /// A hint for liquid that is inside a mesh, which may be solid against expectation; else empty.
  static std::string hint_of(const sim::Settings& settings, std::size_t obstacle) {
    const sim::Shape& shape = settings.obstacles[obstacle].shape;
    return std::holds_alternative<sim::TriangleMesh>(shape)
               ? ", a mesh that is solid there: for a hollow one, its inner surface must face "
                 "inward"
               : "";
  }

  void check_sinks() {
    const auto& sinks = scene_.simulation.sinks;
    for (std::size_t i = 0; i < sinks.size(); ++i)
      check_shape(sinks[i].shape, child_path("sinks", i));
  }

  void check_emitters() {
    for (const Diagnostic& wrong : check_exchange(scene_))
      complain(wrong.path, wrong.message);
  }

  template <class Key>
  void check_times(const std::vector<Key>& keys, const std::string& path) {
    for (std::size_t i = 1; i < keys.size(); ++i) {
      if (!(keys[i - 1].time < keys[i].time)) {
        complain(child_path(child_path(path, i), "time"),
                 fmt::format("{:g} s is not after the key before it ({:g} s)", keys[i].time,
                             keys[i - 1].time));
      }
    }
  }

  void check_forces_and_solver() {
    check_times(scene_.simulation.forces.body, "forces.body");
    const auto& solver = scene_.simulation.solver;
    if (solver.min_iterations > solver.max_iterations) {
      complain("solver.min_iterations", fmt::format("{} is above max_iterations ({})",
                                                    solver.min_iterations, solver.max_iterations));
    }
    if (solver.min_time_step > solver.max_time_step) {
      complain("solver.min_time_step", fmt::format("{:g} s is above max_time_step ({:g} s)",
                                                   solver.min_time_step, solver.max_time_step));
    }
  }

  void check_picture() {
    const VideoConfig& video = scene_.video;
    if (video.width % 2 != 0)
      complain("video.width", fmt::format("{} is odd; accepted: even numbers", video.width));
    if (video.height % 2 != 0)
      complain("video.height", fmt::format("{} is odd; accepted: even numbers", video.height));
    const double rate = video.frames_per_second.per_second();
    if (video.duration * rate > 1e6 || video.frame_count() < 1) {
      complain(
          "video.duration",
          fmt::format("{:g} s at {:g} frames per second are {:.0f} frames; accepted: 1 ... 1000000",
                      video.duration, rate, video.duration * rate));
    }
    if (glm::length(scene_.light.direction) < 1e-6f)
      complain("light.direction", "has no length");
    if (scene_.look.color_min > scene_.look.color_max) {
      complain("look.color_min", fmt::format("{:g} is above color_max ({:g})",
                                             scene_.look.color_min, scene_.look.color_max));
    }
  }

  void check_probes() {
    const auto& probes = scene_.probes;
    std::map<std::string_view, std::size_t> names;
    for (std::size_t i = 0; i < probes.size(); ++i) {
      const std::string path = child_path("probes", i);
      check_probe_name(probes[i].name, child_path(path, "name"));
      if (const auto [first, is_new] = names.emplace(probes[i].name, i); !is_new) {
        complain(child_path(path, "name"), fmt::format("\"{}\" is the name of probes[{}] already",
                                                       shown(probes[i].name), first->second));
      }
      check_probe_place(probes[i], path);
    }
    if (!probes.empty() && scene_.video.duration * scene_.probes_rate > 1e6) {
      complain("probes_rate", fmt::format("{:g} readings per second for {:g} s are {:g}; at most "
                                          "1000000 are accepted",
                                          scene_.probes_rate, scene_.video.duration,
                                          scene_.video.duration * scene_.probes_rate));
    }
  }

  void check_probe_name(const std::string& name, const std::string& path) {
    const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
      return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') ||
             c == '_' || c == '-';
    });
    if (name.empty() || !plain) {
      complain(path, fmt::format("\"{}\" can't name a column; accepted: letters, digits, _ and -",
                                 shown(name)));
    }
  }

  /// Checks that a probe that has a place lies in the domain.
  void check_probe_place(const sim::Probe& probe, const std::string& path) {
    const auto& domain = scene_.simulation.domain;
    glm::vec3 place = 0.5f * (domain.min + domain.max);
    std::string key;
    if (const auto* height = std::get_if<sim::SurfaceHeightProbe>(&probe.quantity)) {
      place.x = height->x;
      place.z = height->z;
      key = "surface_height";
    } else if (const auto* pressure = std::get_if<sim::PressureProbe>(&probe.quantity)) {
      place = pressure->point;
      key = "pressure.point";
    }
    for (int axis = 0; axis < 3; ++axis) {
      if (place[axis] < domain.min[axis] || place[axis] > domain.max[axis]) {
        return complain(child_path(path, key),
                        fmt::format("{} = {:g} m is outside the domain {} ... {}", "xyz"[axis],
                                    place[axis], vector_text(domain.min), vector_text(domain.max)));
      }
    }
  }

  void check_camera() {
    const auto& keys = scene_.camera.keyframes;
    check_times(keys, "camera.keyframes");
    for (std::size_t i = 0; i < keys.size(); ++i) {
      const std::string path = child_path("camera.keyframes", i);
      const glm::vec3 forward = keys[i].target - keys[i].position;
      if (glm::length(forward) < 1e-6f) {
        complain(path, "position and target are the same point");
        continue;
      }
      const glm::vec3 across = glm::cross(glm::normalize(forward), keys[i].up);
      if (glm::length(across) < 1e-4f * glm::length(keys[i].up) || glm::length(keys[i].up) == 0.f) {
        complain(path, fmt::format("up {} is along the view from {} to {}", vector_text(keys[i].up),
                                   vector_text(keys[i].position), vector_text(keys[i].target)));
      }
    }
  }

  const Scene& scene_;
  const SceneDocument& document_;
  std::vector<Problem> problems_;
};

}  // namespace

void check_scene(const Scene& scene, const SceneDocument& document) {
  throw_if_any(Checker(scene, document).check());
}

}  // namespace spindrift::app
