// How many pictures a second of a video has, as an exact fraction.
#pragma once

#include <cmath>

namespace spindrift {

/// 30 a second, or 30000/1001 (NTSC).
struct FrameRate {
  constexpr FrameRate(int n = 30, int d = 1) : numerator(n), denominator(d) {}

  int numerator;    ///< pictures
  int denominator;  ///< s

  /// Rounded, 1/s.
  double per_second() const { return static_cast<double>(numerator) / denominator; }

  /// When a picture is due, s; the first, number 0, at 0.
  double time_of(int picture) const {
    return static_cast<double>(picture) * denominator / numerator;
  }

  /// The number of pictures that last so long, s; also that of the picture nearest to a time.
  int count_in(double seconds) const {
    return static_cast<int>(std::lround(seconds * numerator / denominator));
  }

  bool operator==(const FrameRate&) const = default;
};

}  // namespace spindrift
