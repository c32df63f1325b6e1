// Eight numbers at once, for the formulas on the CPU: one AVX register, or two SSE ones. The order
// of operations is the same on both, and so are the results.
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

inline Lanes at_least(Lanes x, float least) {
#ifdef __AVX__
  return _mm256_max_ps(x, _mm256_set1_ps(least));
#else
  const Lanes limit = Lanes{} + least;
  return x > limit ? x : limit;
#endif
}

/// The largest whole numbers not above x, which must fit 32-bit integers.
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

/// The indices of eight elements that follow each other, from `first` on.
struct LaneRun {
  std::uint32_t first;
};
inline Lanes load(const float* a, LaneRun run) {
  return consecutive(a + run.first);
}

/// The indices of eight arbitrary elements, in eight consecutive integers. Each is kept as a place:
/// the offset in bytes of the element's row of four floats. Shifting an index for every row took a
/// tenth of a pass's instructions.
struct LaneList {
  const std::uint32_t* places;
  static constexpr int row_bits = 4;
  static constexpr std::uint32_t place_of(std::uint32_t number) { return number << row_bits; }
  static constexpr std::uint32_t number_at(std::uint32_t place) { return place >> row_bits; }
};

/// The elements of an array at eight indices.
inline Lanes load(const float* a, IndexLanes j) {
#ifdef __AVX2__
  // The instruction merges into its target register. Merging into zeros, it need not wait for what
  // the register held before; _mm256_i32gather_ps() leaves that open, and gathers wait in a row.
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

inline Lanes load(const float* a, LaneList list) {
  using Places = std::uint32_t __attribute__((vector_size(sizeof(IndexLanes))));
  Places places;
  __builtin_memcpy(&places, list.places, sizeof places);
  return load(a, reinterpret_cast<IndexLanes>(places >> LaneList::row_bits));
}

/// Eight rows of four numbers, column by column.
struct LaneRows {
  Lanes x, y, z, value;
};

/// Loads eight rows of four floats and transposes them. Loading rows whole and transposing them
/// takes half the time of gathering their numbers one by one.
/// @param row row(k) is the address of the k-th row, a multiple of 16 bytes
template <class Row>
inline LaneRows transposed(Row row) {
#ifdef __AVX2__
  const auto pair = [&](int k) {
    return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_load_ps(row(k))),
                                _mm_load_ps(row(k + 4)), 1);
  };
  const __m256 r0 = pair(0), r1 = pair(1), r2 = pair(2), r3 = pair(3);
  const __m256 xy_low = _mm256_unpacklo_ps(r0, r1), zv_low = _mm256_unpackhi_ps(r0, r1),
               xy_high = _mm256_unpacklo_ps(r2, r3), zv_high = _mm256_unpackhi_ps(r2, r3);
  return {_mm256_shuffle_ps(xy_low, xy_high, 0x44), _mm256_shuffle_ps(xy_low, xy_high, 0xee),
          _mm256_shuffle_ps(zv_low, zv_high, 0x44), _mm256_shuffle_ps(zv_low, zv_high, 0xee)};
#else
  LaneRows r;
  for (int k = 0; k < lane_count; ++k) {
    const float* const from = row(k);
    r.x[k] = from[0];
    r.y[k] = from[1];
    r.z[k] = from[2];
    r.value[k] = from[3];
  }
  return r;
#endif
}

/// Sum of the lanes, always in the same order.
inline float reduce(Lanes v) {
#ifdef __AVX__
  const __m128 four = _mm_add_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  const __m128 two = _mm_add_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_add_ss(two, _mm_movehdup_ps(two)));
#else
  const float s0 = v[0] + v[4], s1 = v[1] + v[5], s2 = v[2] + v[6], s3 = v[3] + v[7];
  return (s0 + s2) + (s1 + s3);
#endif
}

}  // namespace spindrift::sim
