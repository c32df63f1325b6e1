#include "sim/outflow.hpp"

#include "sim/measure.hpp"
#include "sim/particle_exchange.hpp"
#include "sim/solid.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {
namespace {

bool is_outside(const Vec3<float>& p, const Box& box) {
  return p.x < box.min.x || p.y < box.min.y || p.z < box.min.z || p.x > box.max.x ||
         p.y > box.max.y || p.z > box.max.z;
}

struct Found {
  bool any = false;
  void join(const Found& o) { any = any || o.any; }
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
      reach_(reach_of(settings)) {}

/// Within the domain contact keeps particles off its walls. Around the edge of an opening there is
/// no way back.
Outflow::Way Outflow::way_of(const Vec3<float>& p) const {
  for (const Sink& sink : settings_.sinks)
    if (contains(sink.shape, p))
      return drained;
  return open_.any && open_.is_beyond(p) && is_outside(p, reach_) ? left : stays;
}

Exchange Outflow::apply(Executor& executor, Particles& particles, const float* held) {
  const Vec3Arrays x = particles.position.view(), v = particles.velocity.view();
  gone_.resize(particles.count);
  const bool any = executor
                       .reduce_on_host<Found>("outflow", particles.count,
                                              [&](std::uint32_t i) {
                                                const bool carried = held != nullptr && held[i] > 0;
                                                gone_[i] = carried ? stays : way_of(x[i]);
                                                return Found{gone_[i] != stays};
                                              })
                       .any;
  Exchange exchange;
  if (!any)
    return exchange;
  for (std::uint32_t i = 0; i < particles.count; ++i) {
    exchange.drained += gone_[i] == drained;
    exchange.left += gone_[i] == left;
    if (gone_[i] != stays)
      exchange.energy_out +=
          energy_of(constants_, settings_, {x.x[i], x.y[i], x.z[i]}, {v.x[i], v.y[i], v.z[i]});
  }
  remove_particles(particles, gone_);
  return exchange;
}

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
