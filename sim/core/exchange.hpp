// Counts of the particles that enter and leave the domain during a run.
#pragma once

#include <cstdint>

namespace spindrift::sim {

/// What entered and left the domain between two frames.
struct Exchange {
  std::int64_t entered = 0;    ///< particles that emitters brought in
  std::int64_t held_back = 0;  ///< particles not brought in because liquid was in their place
  std::int64_t drained = 0;    ///< particles that sinks took away
  std::int64_t left = 0;       ///< particles that left through open faces
  double energy_in = 0;        ///< kinetic and potential energy of the particles that came, J
  double energy_out = 0;       ///< kinetic and potential energy of the particles that went, J

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
