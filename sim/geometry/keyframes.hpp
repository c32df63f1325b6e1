// Interpolation of numbers between keyframes in time, for the motion of bodies and of the camera.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace spindrift::geometry {

/// The slope of the curve at a key: the harmonic mean of the slopes of the spans before and after
/// it, and 0 at a turning point, so that the curve stays between the keys.
inline double key_slope(double before, double after) {
  return before * after > 0. ? 2. * before * after / (before + after) : 0.;
}

/// The same numbers in double precision.
template <std::size_t N>
std::array<double, N> in_double(const std::array<float, N>& values) {
  std::array<double, N> result;
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

/// The numbers at a time (s). Between keys each number follows a monotone cubic (Fritsch & Carlson
/// 1980), which has slope 0 at the first and the last key and overshoots no key, or a straight
/// line; before the first and after the last key it is constant.
/// @param keys at least one, in ascending order of their member `time`, s
/// @param numbers_of returns the numbers of a key as a std::array of float
/// @param linear whether numbers follow straight lines
template <class Key, class NumbersOf>
auto numbers_at(const std::vector<Key>& keys, double time, NumbersOf numbers_of, bool linear) {
  auto result = in_double(numbers_of(keys.front()));
  if (time <= keys.front().time)
    return result;
  if (time >= keys.back().time)
    return in_double(numbers_of(keys.back()));
  const auto next = std::upper_bound(keys.begin(), keys.end(), time,
                                     [](double t, const Key& k) { return t < k.time; });
  const auto i = static_cast<std::size_t>(next - keys.begin()) - 1;

  const double span = static_cast<double>(keys[i + 1].time) - keys[i].time;
  const double s = (time - keys[i].time) / span;
  const auto a = numbers_of(keys[i]), b = numbers_of(keys[i + 1]);
  // The slope of number c between keys k and k + 1.
  const auto slope_of = [&](std::size_t k, std::size_t c) {
    const double from = numbers_of(keys[k])[c], to = numbers_of(keys[k + 1])[c];
    return (to - from) / (static_cast<double>(keys[k + 1].time) - keys[k].time);
  };
  for (std::size_t c = 0; c < result.size(); ++c) {
    if (linear) {
      result[c] = (1. - s) * a[c] + s * b[c];
      continue;
    }
    const double slope = slope_of(i, c);
    const double at_a = i == 0 ? 0. : key_slope(slope_of(i - 1, c), slope);
    const double at_b = i + 2 == keys.size() ? 0. : key_slope(slope, slope_of(i + 1, c));
    const double s2 = s * s, s3 = s2 * s;
    result[c] = (2. * s3 - 3. * s2 + 1.) * a[c] + (3. * s2 - 2. * s3) * b[c] +
                ((s3 - 2. * s2 + s) * at_a + (s3 - s2) * at_b) * span;
  }
  return result;
}

}  // namespace spindrift::geometry
