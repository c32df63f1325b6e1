// Defines the frame rate of a video as an exact fraction.
#pragma once

#include <cmath>

namespace spindrift {

/// Pictures per second as a fraction: 30/1, say, or 30000/1001 (NTSC).
struct FrameRate {
  // A whole number is a rate. NOLINTNEXTLINE(google-explicit-constructor)
  constexpr FrameRate(int n = 30, int d = 1) : numerator(n), denominator(d) {}

  int numerator;    ///< pictures
  int denominator;  ///< s that these pictures last

  /// Returns the rate as a rounded number, 1/s.
  double per_second() const { return static_cast<double>(numerator) / denominator; }

  /// Returns the time at which a picture is due, s; picture 0, the first, is due at 0.
  double time_of(int picture) const {
    return static_cast<double>(picture) * denominator / numerator;
  }

  /// Returns the number of pictures that last `seconds`, rounded. This is also the number of the
  /// picture that is due nearest to that time.
  int count_in(double seconds) const {
    return static_cast<int>(std::lround(seconds * numerator / denominator));
  }

  bool operator==(const FrameRate&) const = default;
};

}  // namespace spindrift
