// Filters planes of pixels with separable filters, row by row, for the metrics. Beyond its edges a
// plane repeats them.
//
// Real is float, or double where small differences of large sums are wanted.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

#include "render/lanes.hpp"

namespace spindrift::compare {

/// Weights of a filter of odd length, the middle one at the pixel itself.
template <class Real>
using Taps = std::vector<Real>;

/// The length of every row is padded to a multiple of this number of values.
inline constexpr int row_multiple = lane_count<float>;

/// Returns the width rounded up to a multiple of row_multiple.
inline int padded_width(int width) {
  return (width + row_multiple - 1) / row_multiple * row_multiple;
}

/// A plane of one value per pixel. Rows are padded, so that they can be read in whole lanes.
template <class Real>
class Plane {
 public:
  Plane(int width, int height)
      : height_(height),
        stride_(padded_width(width)),
        values_(static_cast<std::size_t>(stride_) * height) {}

  /// Returns row y, or the row nearest to it where y lies outside the plane.
  Real* row(int y) { return &values_[index(y)]; }
  const Real* row(int y) const { return &values_[index(y)]; }

 private:
  std::size_t index(int y) const {
    return static_cast<std::size_t>(std::clamp(y, 0, height_ - 1)) * stride_;
  }

  int height_, stride_;
  std::vector<Real> values_;
};

/// Sets out[x] for x = 0 ... count - 1 to the sum over all taps k, counted from 0, of
/// taps[k] * at(k)[x]. `count` is rounded up to whole lanes, for which all rows must have room.
template <class Real, class At>
void weighted_sum(const Taps<Real>& taps, const At& at, int count, Real* out) {
  for (int x = 0; x < count; x += lane_count<Real>) {
    LanesOf<Real> sum{};
    for (std::size_t k = 0; k < taps.size(); ++k)
      sum += taps[k] * load_lanes(at(static_cast<int>(k)) + x);
    std::memcpy(out + x, &sum, sizeof sum);
  }
}

/// Filters one row of a plane, first across the rows around it, and then along itself.
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

  /// Writes the row, filtered along itself, to `out`, which has room for padded_width() values.
  void filter(const Taps<Real>& taps, Real* out) const {
    const Real* const first = &padded_[margin] - taps.size() / 2;
    weighted_sum(
        taps, [&](int k) { return first + k; }, stride_, out);
  }

 private:
  static constexpr int margin = 16;  ///< pixels at either end; the longest filters reach 10

  int width_, stride_;
  std::vector<Real> padded_;
};

}  // namespace spindrift::compare
