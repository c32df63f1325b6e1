// Liquid that sinks take and that leaves through open faces.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/backend.hpp"
#include "sim/exchange.hpp"
#include "sim/formulas.hpp"
#include "sim/open_faces.hpp"
#include "sim/particles.hpp"

namespace spindrift::sim::inline SPINDRIFT_BACKEND {

class Outflow {
 public:
  Outflow(const Settings& settings, const FluidConstants& constants);

  bool exists() const { return open_.any || !settings_.sinks.empty(); }

  /// Takes away particles that are in a sink or out of reach beyond an open face, but for those
  /// with held[i] = 1; `held` may be null.
  Exchange apply(Executor& executor, Particles& particles, const float* held);

 private:
  enum Way : std::uint8_t { stays, drained, left };
  Way way_of(const Vec3<float>& p) const;

  Settings settings_;
  FluidConstants constants_;
  OpenFaces open_;
  Box reach_;  ///< what is beyond an open face comes back, or is looked at yet, within this, m
  std::vector<std::uint8_t> gone_;
};

/// How far a particle may be out of the domain without being lost: two spacings beyond an open
/// face, and ten of the domain's sizes beyond one that gravity pulls it back through, straight out
/// of the opening.
Box reach_of(const Settings& settings);

}  // namespace spindrift::sim::inline SPINDRIFT_BACKEND
