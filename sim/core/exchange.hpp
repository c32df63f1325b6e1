// Particles that come and go.
#pragma once

#include <cstdint>

namespace spindrift::sim {

/// What came and went between two frames.
struct Exchange {
  std::int64_t entered = 0;    ///< particles that emitters brought
  std::int64_t held_back = 0;  ///< those that they did not: there was liquid in their place
  std::int64_t drained = 0;    ///< particles that sinks took
  std::int64_t left = 0;       ///< particles that went out through open faces
  double energy_in = 0;        ///< kinetic and potential, that came with particles, J
  double energy_out = 0;       ///< that went with them, J

  Exchange& operator+=(const Exchange& o) {
    entered += o.entered;
    held_back += o.held_back;
    drained += o.drained;
    left += o.left;
    energy_in += o.energy_in;
    energy_out += o.energy_out;
    return *this;
  }
};

}  // namespace spindrift::sim
