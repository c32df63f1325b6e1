#include "app/checks/exchange_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>
#include <variant>

#include "app/errors/shown_text.hpp"
#include "app/scene/scene_fields.hpp"
#include "app/tables/document.hpp"
#include "sim/boundary/obstacle_motion.hpp"
#include "sim/core/from_glm.hpp"
#include "sim/core/open_faces.hpp"
#include "sim/flow/nozzle.hpp"
#include "sim/geometry/shape.hpp"

namespace spindrift::app {
namespace {

constexpr float least_width = 2.f;  // of an opening, in particle spacings

std::optional<Diagnostic> check_direction(const glm::vec3& direction, const std::string& path) {
  if (glm::length(direction) < 1e-6f)
    return Diagnostic{child_path(path, "direction"), "has no length"};
  return std::nullopt;
}

std::optional<Diagnostic> check_width(float width, float spacing, const std::string& path) {
  if (width < 0.999f * least_width * spacing)
    return Diagnostic{path,
                      fmt::format("the opening is {:g} m wide; at least {:g} particle spacings "
                                  "({:g} m) are needed",
                                  width, least_width, least_width * spacing)};
  return std::nullopt;
}

std::optional<Diagnostic> check(const sim::Disc& disc, float spacing, const std::string& path) {
  if (auto wrong = check_direction(disc.direction, path))
    return wrong;
  return check_width(2 * disc.radius, spacing, child_path(path, "radius"));
}

std::optional<Diagnostic> check(const sim::Rectangle& r, float spacing, const std::string& path) {
  if (auto wrong = check_direction(r.direction, path))
    return wrong;
  const glm::vec3 across = glm::cross(r.up, glm::normalize(r.direction));
  if (glm::length(across) <= 1e-4f * glm::length(r.up))
    return Diagnostic{
        child_path(path, "up"),
        fmt::format("{} is along the direction {}", vector_text(r.up), vector_text(r.direction))};
  if (auto wrong = check_width(r.width, spacing, child_path(path, "width")))
    return wrong;
  return check_width(r.height, spacing, child_path(path, "height"));
}

/// Checks that particles half a spacing beyond the opening are in the domain and outside of fixed
/// obstacles.
std::optional<Diagnostic> check_place(const sim::Settings& s, const sim::Opening& opening,
                                      const std::string& path) {
  const glm::vec3 ahead = 0.5f * s.fluid.spacing * sim::direction_of(opening);
  const float tolerance = 1e-3f * s.fluid.spacing;
  for (const glm::vec3& point : sim::fill_opening(opening, s.fluid.spacing).points) {
    const glm::vec3 p = point + ahead;
    if (glm::any(glm::lessThan(p, s.domain.min - tolerance)) ||
        glm::any(glm::greaterThan(p, s.domain.max + tolerance)))
      return Diagnostic{
          path, fmt::format("the particle that comes out at {} is outside the domain "
                            "{} ... {}; move center or turn direction",
                            vector_text(p), vector_text(s.domain.min), vector_text(s.domain.max))};
    for (std::size_t k = 0; k < s.obstacles.size(); ++k)
      if (!s.obstacles[k].motion && sim::is_inside(s.obstacles[k].shape, p))
        return Diagnostic{path, fmt::format("the particle that comes out at {} is inside "
                                            "obstacles[{}]; move center out of it",
                                            vector_text(p), k)};
  }
  return std::nullopt;
}

/// Checks that no moving obstacle enters the nozzle while it is open. A fixed obstacle may contain
/// the nozzle, which then removes the obstacle's boundary particles in its way.
std::optional<Diagnostic> check_way(const Scene& scene, const sim::Emitter& emitter,
                                    const std::string& path) {
  const sim::Settings& s = scene.simulation;
  const sim::Nozzle nozzle(emitter, s.fluid.spacing);
  const std::vector<glm::vec3> points = sim::fill_opening(emitter.opening, s.fluid.spacing).points;
  const glm::vec3 step = s.fluid.spacing * sim::direction_of(emitter.opening);
  for (std::size_t k = 0; k < s.obstacles.size(); ++k)
    for (int frame = 0; s.obstacles[k].motion && frame <= scene.video.frame_count(); ++frame) {
      const double time = scene.video.frames_per_second.time_of(frame);
      if (!(nozzle.closed_part(time) < 1))
        continue;
      const sim::Pose pose = sim::pose_at(s.obstacles[k], time);
      const glm::dmat3 back = glm::transpose(pose.rotation);
      for (const glm::vec3& point : points)
        for (int layer = -sim::Nozzle::depth; layer <= 1; ++layer) {
          const glm::dvec3 p(point + static_cast<float>(layer) * step);
          if (sim::is_inside(s.obstacles[k].shape, glm::vec3(back * (p - pose.translation))))
            return Diagnostic{path,
                              fmt::format("obstacles[{}], which moves, is in the nozzle, four "
                                          "spacings behind the opening, at {:g} s; move "
                                          "either out of the other's way",
                                          k, time)};
        }
    }
  return std::nullopt;
}

/// The space near a nozzle that liquid can take up.
class Room {
 public:
  /// @param reach distance from the points up to which obstacles are considered, m
  Room(const sim::Settings& s, const std::vector<glm::vec3>& points, float reach) : settings_(s) {
    sim::Box around{points[0], points[0]};
    for (const glm::vec3& p : points)
      around = {glm::min(around.min, p), glm::max(around.max, p)};
    around = {around.min - reach, around.max + reach};
    for (const sim::Obstacle& obstacle : s.obstacles)
      if (!obstacle.motion && !sim::is_apart(sim::bounds_of(obstacle.shape), around))
        standing_.push_back(&obstacle.shape);
  }

  /// Whether a place is in the domain, or in front of an open face of it, and in no fixed obstacle.
  bool is_at(const glm::vec3& p) const {
    return sim::OpenFaces(settings_.domain).is_before(sim::from_glm(p), settings_.domain) &&
           std::none_of(standing_.begin(), standing_.end(),
                        [&](const sim::Shape* shape) { return sim::is_inside(*shape, p); });
  }

 private:
  const sim::Settings& settings_;
  std::vector<const sim::Shape*> standing_;  ///< fixed obstacles near the nozzle
};

/// The shortest way from a place in a wall to a place that liquid can take up.
struct WayOut {
  float length = 0;          ///< spacings
  glm::vec3 direction{0.f};  ///< of unit length, about normal to the wall's face; zero where there
                             ///< is no way
};

/// A hundred directions of unit length, spread evenly: a golden-angle spiral on the sphere.
const std::array<glm::vec3, 100>& all_directions() {
  static const auto directions = [] {
    std::array<glm::vec3, 100> made;
    for (std::size_t k = 0; k < made.size(); ++k) {
      const double z = 1 - (2. * static_cast<double>(k) + 1) / made.size();
      const double across = std::sqrt(1 - z * z),
                   angle = 2.399963229728653 * static_cast<double>(k);
      made[k] = glm::vec3(across * std::cos(angle), across * std::sin(angle), z);
    }
    return made;
  }();
  return directions;
}

/// The distance, in spacings, by which the directions of a way are looked at beyond its end.
constexpr float looked_beyond = 0.25f;

/// Looks in all directions for the nearest place that liquid can take up and for which `counts`
/// returns true, up to `most` spacings away.
template <class Counts>
WayOut way_out(const Room& room, float spacing, const glm::vec3& place, float most,
               const Counts& counts) {
  constexpr float step = 0.125f;  // spacings
  struct Ways {
    int count = 0;
    glm::vec3 sum{0.f};
  };
  const auto ways_of = [&](float length) {
    Ways ways;
    for (const glm::vec3& along : all_directions()) {
      const glm::vec3 p = place + length * spacing * along;
      if (counts(p) && room.is_at(p)) {
        ++ways.count;
        ways.sum += along;
      }
    }
    return ways;
  };
  // Only a few directions get out at first. A little further on they fill a cone, and their mean is
  // its axis.
  for (float length = step; length < most; length += step)
    if (ways_of(length).count > 0) {
      const glm::vec3 sum = ways_of(length + looked_beyond).sum;
      return {length, glm::length(sum) > 0 ? glm::normalize(sum) : glm::vec3(0.f)};
    }
  return {most, glm::vec3(0.f)};
}

/// Checks that a wall around the nozzle is thick enough. Liquid on the wall's other side must not
/// come near the liquid in the nozzle, as the entering layers would be among its neighbours.
/// Measured: with 1.5 spacings to the wall's other side the solver's limits on compression hold,
/// with 1.3 the liquid is compressed by 7 %, with 1.0 by 25 %. In front of the face that the nozzle
/// comes out of, the limits hold where the nozzle is turned by 20° from the face's normal, but not
/// always at 30°.
std::optional<Diagnostic> check_walls(const sim::Settings& s, const sim::Opening& opening,
                                      const std::string& path) {
  constexpr float needed = 1.5f, behind = 0.5f;  // spacings
  constexpr float most_turned = 20, roughness = 5, deg = std::numbers::pi_v<float> / 180;
  const float margin = behind * s.fluid.spacing;
  const glm::vec3 direction = sim::direction_of(opening);
  const sim::OpeningPoints filled = sim::fill_opening(opening, s.fluid.spacing);
  const float depth = static_cast<float>(sim::Nozzle::depth + 1) * filled.layer_distance;
  const Room room(s, filled.points, depth + (needed + looked_beyond) * s.fluid.spacing);
  float least = needed;
  glm::vec3 where(0.f);
  for (const glm::vec3& point : filled.points)
    for (int layer = 0; layer <= sim::Nozzle::depth; ++layer) {
      const glm::vec3 p =
          point - (static_cast<float>(layer) + 0.01f) * filled.layer_distance * direction;
      if (room.is_at(p))
        continue;
      const WayOut nearest =
          way_out(room, s.fluid.spacing, p, needed, [](const glm::vec3&) { return true; });
      const bool own_face =
          glm::dot(nearest.direction, direction) > std::cos((most_turned + roughness) * deg);
      const glm::vec3 at = own_face ? p + nearest.length * s.fluid.spacing * nearest.direction
                                    : point,
                      normal = own_face ? nearest.direction : direction;
      const WayOut way = way_out(room, s.fluid.spacing, p, least, [&](const glm::vec3& other) {
        return glm::dot(other - at, normal) < -margin;
      });
      if (way.length < least) {
        least = way.length;
        where = p;
      }
    }
  if (least >= needed)
    return std::nullopt;
  return Diagnostic{
      path,
      fmt::format("the nozzle, four spacings behind the opening, lies in a wall that is too thin, "
                  "or comes out of it aslant: at {} liquid can be {:g} spacings ({:g} m) from it, "
                  "beside it or on the wall's other side; {:g} spacings ({:.3g} m) are needed, so "
                  "make the wall thicker, the opening or fluid.spacing smaller, move center, or "
                  "turn direction to within {:g}° of the right angle to the wall's face",
                  vector_text(where), least, least * s.fluid.spacing, needed,
                  needed * s.fluid.spacing, most_turned)};
}

std::optional<Diagnostic> check_emitter(const Scene& scene, const sim::Emitter& emitter,
                                        const std::string& path) {
  const sim::Settings& s = scene.simulation;
  const std::string opening_path =
      child_path(path, alternative_names<sim::Opening>[emitter.opening.index()]);
  if (auto wrong =
          std::visit([&](const auto& one) { return check(one, s.fluid.spacing, opening_path); },
                     emitter.opening))
    return wrong;
  if (!(emitter.from < emitter.to))
    return Diagnostic{child_path(path, "to"),
                      fmt::format("{:g} s is not after from ({:g} s)", emitter.to, emitter.from)};
  if (auto wrong = check_place(s, emitter.opening, opening_path))
    return wrong;
  if (auto wrong = check_walls(s, emitter.opening, opening_path))
    return wrong;
  if (auto wrong = check_way(scene, emitter, opening_path))
    return wrong;
  const sim::Nozzle nozzle(emitter, s.fluid.spacing);
  if (nozzle.layer_count() > 0)
    return std::nullopt;
  if (emitter.max_particles > 0 && emitter.max_particles < static_cast<int>(nozzle.layer_size()))
    return Diagnostic{child_path(path, "max_particles"),
                      fmt::format("{} is less than the {} of one layer", emitter.max_particles,
                                  nozzle.layer_size())};
  return Diagnostic{child_path(path, "to"),
                    fmt::format("from {:g} to {:g} s at {:g} m/s liquid goes less than half a "
                                "spacing: nothing comes out",
                                emitter.from, emitter.to, emitter.speed)};
}

void check_open_faces(const sim::DomainSettings& domain, std::vector<Diagnostic>& wrong) {
  for (std::size_t i = 0; i < domain.open.size(); ++i)
    if (std::find(domain.open.begin(), domain.open.begin() + static_cast<std::ptrdiff_t>(i),
                  domain.open[i]) != domain.open.begin() + static_cast<std::ptrdiff_t>(i))
      wrong.push_back(
          {child_path("domain.open", i),
           fmt::format("\"{}\" stands there already",
                       value_names<sim::Direction>[static_cast<std::size_t>(domain.open[i])])});
}

}  // namespace

std::vector<Diagnostic> check_exchange(const Scene& scene) {
  std::vector<Diagnostic> wrong;
  const auto& emitters = scene.simulation.fluid.emitters;
  for (std::size_t i = 0; i < emitters.size(); ++i)
    if (auto first = check_emitter(scene, emitters[i], child_path("fluid.emitters", i)))
      wrong.push_back(std::move(*first));
  check_open_faces(scene.simulation.domain, wrong);
  return wrong;
}

}  // namespace spindrift::app
