// Eight floats that are worked on at once: one register with AVX, two with SSE.
#pragma once

#include <cstdint>

namespace spindrift::surface {

inline constexpr int lanes = 8;

/// Lane i is lanes[i]; arithmetic is lane by lane, and with a float on every lane.
using Lanes = float __attribute__((vector_size(lanes * sizeof(float))));

/// Without a comparison, for which GCC leaves vector code where there is no AVX.
inline Lanes absolute(Lanes lanes) {
  using Bits = std::int32_t __attribute__((vector_size(sizeof(Lanes))));
  return Lanes(Bits(lanes) & 0x7fffffff);
}

}  // namespace spindrift::surface
