// Liquid that sinks take and that leaves through open faces.
#pragma once

#include <cstdint>
#include "sim/backend/backend.hpp"
#include "sim/core/exchange.hpp"
#include "sim/core/open_faces.hpp"
#include "sim/geometry/solid.hpp"
#include "sim/particles/formulas.hpp"
#include "sim/particles/particle_exchange.hpp"
#include "sim/particles/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

enum class WayOut : std::uint8_t { none, drained, left };

class Outflow {
 public:
  Outflow(const Settings& settings, const FluidConstants& constants);

  bool exists() const { return open_.any || !settings_.sinks.empty(); }

  /// Takes away particles that are in a sink or out of reach beyond an open face, but for those
  /// with held[i] = 1; `held` may be null.
  Exchange apply(Executor& executor, Particles& particles, const float* held);

  /// Where and how fast a particle is that goes.
  struct Going {
    Vec3<float> position, velocity;  ///< m, m/s
    WayOut way;
  };

 private:
  Settings settings_;
  FluidConstants constants_;
  OpenFaces open_;
  Box reach_;  ///< what is beyond an open face comes back, or is looked at yet, within this, m
  Meshes meshes_;
  Array<Solid> sinks_;
  Array<WayOut> way_;  ///< of each particle
  Array<std::uint32_t> chosen_;
  Array<Going> going_;
  ParticleExchange exchange_;
};

/// How far a particle may be out of the domain without being lost: two spacings beyond an open
/// face, and ten of the domain's sizes beyond one that gravity pulls it back through, straight out
/// of the opening.
Box reach_of(const Settings& settings);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
