// Separable filters of planes, row by row. Beyond its edges a plane repeats them.
//
// Real is float, or double where small differences of large sums are wanted.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

namespace spindrift::compare {

/// Weights of a filter of odd length, the middle one at the pixel itself.
template <class Real>
using Taps = std::vector<Real>;

/// Rows are padded to a multiple of this.
inline constexpr int row_multiple = 8;

/// Numbers that are worked on at once, 32 bytes: one register with AVX, two with SSE.
template <class Real>
using Lanes __attribute__((vector_size(32))) = Real;

inline int padded_width(int width) {
  return (width + row_multiple - 1) / row_multiple * row_multiple;
}

/// One value per pixel. Rows are padded, so that they can be read in whole lanes.
template <class Real>
class Plane {
 public:
  Plane(int width, int height)
      : height_(height),
        stride_(padded_width(width)),
        values_(static_cast<std::size_t>(stride_) * height) {}

  /// The row of that number, or the nearest one.
  Real* row(int y) { return &values_[index(y)]; }
  const Real* row(int y) const { return &values_[index(y)]; }

 private:
  std::size_t index(int y) const {
    return static_cast<std::size_t>(std::clamp(y, 0, height_ - 1)) * stride_;
  }

  int height_, stride_;
  std::vector<Real> values_;
};

/// out[x] = the sum of weights times what `at(k)` points to, k counting the taps from 0.
template <class Real, class At>
void weighted_sum(const Taps<Real>& taps, const At& at, int count, Real* out) {
  for (int x = 0; x < count; x += int(sizeof(Lanes<Real>) / sizeof(Real))) {
    Lanes<Real> sum{};
    for (std::size_t k = 0; k < taps.size(); ++k) {
      Lanes<Real> lanes;
      std::memcpy(&lanes, at(static_cast<int>(k)) + x, sizeof lanes);
      sum += taps[k] * lanes;
    }
    std::memcpy(out + x, &sum, sizeof sum);
  }
}

/// A row filtered across the rows around it, and then along itself.
template <class Real>
class RowFilter {
 public:
  explicit RowFilter(int width)
      : width_(width),
        stride_(padded_width(width)),
        padded_(static_cast<std::size_t>(stride_) + 2 * margin) {}

  /// Sets the row to row y of the plane, filtered with the taps over the rows above and below.
  void set(const Plane<Real>& plane, int y, const Taps<Real>& taps) {
    Real* const row = &padded_[margin];
    const int radius = static_cast<int>(taps.size() / 2);
    weighted_sum(
        taps, [&](int k) { return plane.row(y + k - radius); }, stride_, row);
    std::fill(row - margin, row, row[0]);
    std::fill(row + width_, padded_.data() + padded_.size(), row[width_ - 1]);
  }

  /// The row filtered along itself; `out` has room for whole lanes.
  void filter(const Taps<Real>& taps, Real* out) const {
    const Real* const first = &padded_[margin] - taps.size() / 2;
    weighted_sum(
        taps, [&](int k) { return first + k; }, stride_, out);
  }

 private:
  static constexpr int margin = 16;  ///< the longest filters reach 10 pixels

  int width_, stride_;
  std::vector<Real> padded_;
};

}  // namespace spindrift::compare
