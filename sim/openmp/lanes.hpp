// Eight numbers at once: one AVX register, or two SSE ones; the order of operations is the same on
// both, so the results are too.
#pragma once

#include <cmath>
#include <cstdint>
#ifdef __AVX2__
#include <immintrin.h>
#endif

namespace spindrift::sim {

constexpr int lane_count = 8;
using Lanes = float __attribute__((vector_size(lane_count * sizeof(float))));
using IndexLanes = std::int32_t __attribute__((vector_size(lane_count * sizeof(std::int32_t))));

inline Lanes square_root(Lanes x) {
#ifdef __AVX__
  return _mm256_sqrt_ps(x);
#else
  Lanes r;
  for (int k = 0; k < lane_count; ++k)
    r[k] = std::sqrt(x[k]);
  return r;
#endif
}

/// Of numbers that 32-bit integers can hold.
inline Lanes rounded_down(Lanes x) {
  const Lanes whole = __builtin_convertvector(__builtin_convertvector(x, IndexLanes), Lanes);
  return whole > x ? whole - 1.f : whole;
}

/// Eight elements of an array that follow each other.
inline Lanes consecutive(const float* a) {
  Lanes v;
  __builtin_memcpy(&v, a, sizeof v);
  return v;
}

/// Eight elements that follow each other, from `first` on.
struct LaneRun {
  std::uint32_t first;
};
inline Lanes load(const float* a, LaneRun run) {
  return consecutive(a + run.first);
}

/// The elements `j` of an array.
inline Lanes load(const float* a, IndexLanes j) {
#ifdef __AVX2__
  // The instruction merges into its target. With zeros as what it merges into it need not wait for
  // what the register held; _mm256_i32gather_ps() leaves that open, and gathers wait in a row.
  const __m256 zeros = _mm256_setzero_ps();
  const __m256 all = _mm256_castsi256_ps(_mm256_set1_epi32(-1));
  return _mm256_mask_i32gather_ps(zeros, a, reinterpret_cast<__m256i>(j), all, 4);
#else
  Lanes r;
  for (int k = 0; k < lane_count; ++k)
    r[k] = a[j[k]];
  return r;
#endif
}

/// Sum of the lanes, always in the same order.
inline float reduce(Lanes v) {
  const float s0 = v[0] + v[4], s1 = v[1] + v[5], s2 = v[2] + v[6], s3 = v[3] + v[7];
  return (s0 + s2) + (s1 + s3);
}

}  // namespace spindrift::sim
