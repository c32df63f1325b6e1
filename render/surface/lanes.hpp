// Defines a vector of eight floats that are worked on at once: one register with AVX, two with SSE.
#pragma once

#include <cstdint>

namespace spindrift::surface {

inline constexpr int lanes = 8;  ///< floats in a vector

/// A vector v, with the lanes v[0] ... v[7]. Arithmetic is done lane by lane; a float operand
/// stands for a vector with that value in every lane.
using Lanes = float __attribute__((vector_size(lanes * sizeof(float))));

/// Returns the absolute value of every lane, without a comparison, for which GCC leaves vector code
/// where there is no AVX.
inline Lanes absolute(Lanes v) {
  using Bits = std::int32_t __attribute__((vector_size(sizeof(Lanes))));
  return Lanes(Bits(v) & 0x7fffffff);
}

}  // namespace spindrift::surface
