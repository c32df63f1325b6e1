#include "sim/flow/outflow.hpp"

#include "sim/core/from_glm.hpp"
#include "sim/step/measure.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

SPINDRIFT_HD bool is_outside(const Vec3<float>& p, const Box& box) {
  return p.x < box.min.x || p.y < box.min.y || p.z < box.min.z || p.x > box.max.x ||
         p.y > box.max.y || p.z > box.max.z;
}

/// A reduction: whether any particle goes.
struct Found {
  bool any = false;
  SPINDRIFT_HD void join(const Found& o) { any = any || o.any; }
};

}  // namespace

Box reach_of(const Settings& settings) {
  constexpr float falls_back_from = 10.f, lost_beyond = 2.f;
  const DomainSettings& domain = settings.domain;
  Box box{domain.min, domain.max};
  for (const Direction face : domain.open) {
    const int axis = static_cast<int>(face) / 2;
    const float out = static_cast<int>(face) % 2 == 0 ? 1.f : -1.f;
    const bool falls_back = out * settings.forces.gravity[axis] < 0;
    const float far = falls_back ? falls_back_from * (domain.max[axis] - domain.min[axis])
                                 : lost_beyond * settings.fluid.spacing;
    (out > 0 ? box.max : box.min)[axis] += out * far;
  }
  return box;
}

Outflow::Outflow(const Settings& settings, const FluidConstants& constants)
    : settings_(settings),
      constants_(constants),
      open_(settings.domain),
      reach_(reach_of(settings)) {
  std::vector<Solid> sinks;
  for (const Sink& sink : settings.sinks)
    sinks.push_back(solid_of(sink.shape, meshes_));
  put(sinks_, sinks);
}

/// Only particles beyond an open face are tested against the reach: within the domain contact keeps
/// particles off the walls. A particle that has gone around the edge of an opening has no way back.
Exchange Outflow::apply(Executor& executor, Particles& particles, const float* held) {
  const Vec3Arrays x = particles.position.view(), v = particles.velocity.view();
  grow(way_, particles.count);
  WayOut* way = way_.data();
  const Solid* sinks = sinks_.data();
  const std::size_t sink_count = sinks_.size();
  const OpenFaces open = open_;
  const Box reach = reach_;
  const auto find_way = [=] SPINDRIFT_HD(std::uint32_t i) {
    way[i] = WayOut::none;
    if (held != nullptr && held[i] > 0)
      return Found{};
    const Vec3<float> p = x[i];
    for (std::size_t k = 0; k < sink_count && way[i] == WayOut::none; ++k)
      if (sinks[k].contains(to_glm(p)))
        way[i] = WayOut::drained;
    if (way[i] == WayOut::none && open.any && open.is_beyond(p) && is_outside(p, reach))
      way[i] = WayOut::left;
    return Found{way[i] != WayOut::none};
  };
  Exchange exchange;
  if (!executor.reduce<Found>("outflow", particles.count, find_way).any)
    return exchange;
  executor.select("outflow", particles.count, chosen_,
                  [=] SPINDRIFT_HD(std::uint32_t i) { return way[i] != WayOut::none; });
  const auto gone = static_cast<std::uint32_t>(chosen_.size());
  grow(going_, gone);
  Going* going = going_.data();
  const std::uint32_t* chosen = chosen_.data();
  executor.for_each("outflow", gone, [=] SPINDRIFT_HD(std::uint32_t k) {
    const std::uint32_t i = chosen[k];
    going[k] = {x[i], v[i], way[i]};
  });
  executor.wait();
  for (const Going& g : going_) {
    (g.way == WayOut::drained ? exchange.drained : exchange.left) += 1;
    exchange.energy_out +=
        energy_of(constants_, settings_, {g.position.x, g.position.y, g.position.z},
                  {g.velocity.x, g.velocity.y, g.velocity.z});
  }
  executor.select("outflow", particles.count, chosen_,
                  [=] SPINDRIFT_HD(std::uint32_t i) { return way[i] == WayOut::none; });
  exchange_.keep(executor, particles, chosen_);
  return exchange;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
