// Numbers that follow keys in time.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace spindrift::geometry {

/// Slope at a key from the slopes of the spans before and after it: their harmonic mean, 0 at a
/// turning point, so that the curve stays between the keys.
inline double key_slope(double before, double after) {
  return before * after > 0. ? 2. * before * after / (before + after) : 0.;
}

template <std::size_t N>
std::array<double, N> in_double(const std::array<float, N>& values) {
  std::array<double, N> result;
  std::copy(values.begin(), values.end(), result.begin());
  return result;
}

/// The numbers at a time: between keys every one follows a monotone cubic (Fritsch & Carlson 1980),
/// which rests at the first and the last key and overshoots none, or a straight line; outside they
/// are constant.
/// @param keys at least one, in the order of their times
/// @param numbers_of gives a key's numbers, as an array of float
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
  const auto slope_of = [&](std::size_t k, std::size_t c) {  // of number c over span k
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
