#include "sim/run/sight.hpp"

#include <utility>
#include <vector>

#include "sim/boundary/obstacle_motion.hpp"
#include "sim/boundary/posed_body.hpp"
#include "sim/core/open_faces.hpp"

namespace spindrift::sim {
namespace {

/// Leaves the chosen elements of an array, in their order.
template <class T>
void leave(std::vector<T>& values, const std::vector<std::uint32_t>& chosen) {
  for (std::size_t k = 0; k < chosen.size(); ++k)
    values[k] = values[chosen[k]];
  values.resize(chosen.size());
}

bool is_between(const Solid& solid, const glm::vec3& from, const glm::vec3& to, float margin) {
  if (!solid.may_meet(from, to, 0))
    return false;
  const Entry entry = solid.entry_between(from, to);
  return entry.found && (1 - entry.part) * glm::distance(from, to) > margin;
}

}  // namespace

struct Sight::Obstacles {
  std::vector<Solid> fixed;
  std::vector<PosedBody> moving;
  float margin = 0;  ///< within which a place counts as on a surface, m
};

Sight::Sight(const Settings& settings, double time) {
  if (!settings.obstacles.empty())
    obstacles_ = std::make_shared<const Obstacles>(
        Obstacles{.fixed = solids_of(without_moving(settings).obstacles),
                  .moving = posed_bodies(settings, time, time),
                  .margin = 1e-3f * settings.fluid.spacing});
}

bool Sight::is_free(const glm::vec3& from, const glm::vec3& to) const {
  if (!obstacles_)
    return true;
  const auto& [fixed, moving, margin] = *obstacles_;
  for (const Solid& solid : fixed)
    if (is_between(solid, from, to, margin))
      return false;
  for (const PosedBody& body : moving)
    if (is_between(body.solid, to_glm(body.pose.back(from_glm(from))),
                   to_glm(body.pose.back(from_glm(to))), margin))
      return false;
  return true;
}

/// Contact keeps all other particles inside the closed faces.
Frame in_sight(const Settings& settings, Frame frame) {
  if (settings.fluid.emitters.empty())
    return frame;
  const DomainSettings& domain = settings.domain;
  const OpenFaces open(domain);
  const auto is_seen = [&](const glm::vec3& p) {
    const bool inside = glm::all(glm::greaterThanEqual(p, domain.min)) &&
                        glm::all(glm::lessThanEqual(p, domain.max));
    return inside || (open.any && open.is_beyond(from_glm(p)));
  };
  std::vector<std::uint32_t> seen;
  for (std::size_t i = 0; i < frame.positions.size(); ++i)
    if (is_seen(frame.positions[i]))
      seen.push_back(static_cast<std::uint32_t>(i));
  if (seen.size() == frame.positions.size())
    return frame;
  Frame::for_each_of_particles(frame, [&](auto& values) { leave(values, seen); });
  return frame;
}

}  // namespace spindrift::sim
