// Removes the particles that sinks take and those that leave through open faces of the domain.
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

/// How a particle goes out: not at all, into a sink, or through an open face.
enum class WayOut : std::uint8_t { none, drained, left };

/// All sinks and open faces of a run.
class Outflow {
 public:
  Outflow(const Settings& settings, const FluidConstants& constants);

  /// Whether particles can leave at all.
  bool exists() const { return open_.any || !settings_.sinks.empty(); }

  /// Removes the particles that are in a sink, or beyond an open face and outside reach_of().
  /// @param held 1 for each particle that a nozzle carries, which stays; null if there is none
  /// @return the numbers and the energy of the removed particles
  Exchange apply(Executor& executor, Particles& particles, const float* held);

  std::size_t memory_bytes() const {
    return bytes_of(meshes_, sinks_, way_, chosen_, going_, exchange_);
  }

  /// A particle that is being removed.
  struct Going {
    Vec3<float> position, velocity;  ///< m, m/s
    WayOut way;
  };

 private:
  Settings settings_;
  FluidConstants constants_;
  OpenFaces open_;
  Box reach_;  ///< reach_of() the settings, m
  Meshes meshes_;
  Array<Solid> sinks_;
  Array<WayOut> way_;  ///< one per particle
  Array<std::uint32_t> chosen_;
  Array<Going> going_;
  ParticleExchange exchange_;
};

/// The box within which particles beyond open faces are kept, since they may come back or are still
/// to be seen, m. It extends the domain straight out of each open face: by two spacings, or, where
/// gravity pulls particles back through the face, by ten times the domain's size along that axis.
Box reach_of(const Settings& settings);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
