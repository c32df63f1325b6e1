#include "sim/sight.hpp"

#include <algorithm>
#include <utility>

#include "sim/entry.hpp"
#include "sim/motion.hpp"
#include "sim/open_faces.hpp"

namespace spindrift::sim {
namespace {

/// Leaves the chosen elements of an array, in their order.
template <class T>
void leave(std::vector<T>& values, const std::vector<std::uint32_t>& chosen) {
  for (std::size_t k = 0; k < chosen.size(); ++k)
    values[k] = values[chosen[k]];
  values.resize(chosen.size());
}

bool is_between(const Solid& solid, glm::vec3 from, const glm::vec3& to, float margin) {
  if (!may_meet(solid, from, to, 0))
    return false;
  from = to_glm(push_out_of_formula(solid, from_glm(from)));  // but for rounding it was outside
  const glm::vec3 way = to - from;
  const Entry entry = solid.kind == Solid::Kind::mesh ? solid.mesh->entry(from, to, 0)
                                                      : entry_into(solid, from, way);
  return entry.found && (1 - entry.part) * glm::length(way) > margin;
}

}  // namespace

Sight::Sight(const Settings& settings, double time)
    : fixed_(solids_of(without_moving(settings).obstacles)),
      moving_(posed_bodies(settings, time, time)),
      margin_(1e-3f * settings.fluid.spacing) {}

bool Sight::is_free(const glm::vec3& from, const glm::vec3& to) const {
  return std::none_of(fixed_.begin(), fixed_.end(),
                      [&](const Solid& solid) { return is_between(solid, from, to, margin_); }) &&
         std::none_of(moving_.begin(), moving_.end(), [&](const PosedBody& body) {
           return is_between(body.solid, to_glm(body.pose.back(from_glm(from))),
                             to_glm(body.pose.back(from_glm(to))), margin_);
         });
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
  leave(frame.positions, seen);
  leave(frame.velocities, seen);
  for (std::vector<float>* values : {&frame.densities, &frame.pressures, &frame.multipliers})
    leave(*values, seen);
  leave(frame.ids, seen);
  return frame;
}

}  // namespace spindrift::sim
