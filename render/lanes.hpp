// Vectors whose numbers are worked on at once. Arithmetic on them is done lane by lane, in the same
// way on every processor, and so are the results; a number as an operand stands for a vector with
// that number in every lane.
#pragma once

#include <cstdint>
#include <cstring>

namespace spindrift {

/// A vector of 32 bytes with the lanes v[0], v[1] …: one register with AVX, two with SSE.
template <class Real>
using LanesOf __attribute__((vector_size(32))) = Real;

/// The number of lanes of such a vector.
template <class Real>
inline constexpr int lane_count = 32 / sizeof(Real);

/// Eight floats.
using Lanes = LanesOf<float>;

/// Loads numbers that follow each other.
template <class Real>
LanesOf<Real> load_lanes(const Real* from) {
  LanesOf<Real> v;
  std::memcpy(&v, from, sizeof v);
  return v;
}

/// Returns the absolute value of every lane, without a comparison, for which GCC leaves vector code
/// where there is no AVX.
inline Lanes absolute(Lanes v) {
  using Bits = LanesOf<std::int32_t>;
  return Lanes(Bits(v) & 0x7fffffff);
}

}  // namespace spindrift
