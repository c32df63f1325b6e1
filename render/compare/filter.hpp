// Separable filters of planes of floats, row by row. Beyond its edges a plane repeats them.
#pragma once

#include <algorithm>
#include <cstring>
#include <vector>

namespace spindrift::compare {

/// Weights of a filter of odd length, the middle one at the pixel itself.
using Taps = std::vector<float>;

inline constexpr int kLanes = 8;

/// Eight floats that are worked on at once: one register with AVX, two with SSE.
using Lanes = float __attribute__((vector_size(kLanes * sizeof(float))));

/// One value per pixel. Rows are padded, so that they can be read in whole lanes.
class Plane {
 public:
  Plane(int width, int height)
      : height_(height),
        stride_((width + kLanes - 1) / kLanes * kLanes),
        values_(static_cast<std::size_t>(stride_) * height) {}

  /// The row of that number, or the nearest one.
  float* row(int y) { return &values_[index(y)]; }
  const float* row(int y) const { return &values_[index(y)]; }
  int stride() const { return stride_; }

 private:
  std::size_t index(int y) const {
    return static_cast<std::size_t>(std::clamp(y, 0, height_ - 1)) * stride_;
  }

  int height_, stride_;
  std::vector<float> values_;
};

/// out[x] = the sum of weights times what `at(k)` points to, k counting the taps from 0.
template <class At>
void weighted_sum(const Taps& taps, const At& at, int count, float* out) {
  for (int x = 0; x < count; x += kLanes) {
    Lanes sum{};
    for (std::size_t k = 0; k < taps.size(); ++k) {
      Lanes lanes;
      std::memcpy(&lanes, at(static_cast<int>(k)) + x, sizeof lanes);
      sum += taps[k] * lanes;
    }
    std::memcpy(out + x, &sum, sizeof sum);
  }
}

/// A row filtered across the rows around it, and then along itself.
class RowFilter {
 public:
  explicit RowFilter(int width)
      : width_(width),
        stride_((width + kLanes - 1) / kLanes * kLanes),
        padded_(static_cast<std::size_t>(stride_) + 2 * kMargin) {}

  /// Sets the row to row y of the plane, filtered with the taps over the rows above and below.
  void set(const Plane& plane, int y, const Taps& taps) {
    float* const row = &padded_[kMargin];
    const int radius = static_cast<int>(taps.size() / 2);
    weighted_sum(
        taps, [&](int k) { return plane.row(y + k - radius); }, stride_, row);
    std::fill(row - kMargin, row, row[0]);
    std::fill(row + width_, padded_.data() + padded_.size(), row[width_ - 1]);
  }

  /// The row filtered along itself; `out` has room for whole lanes.
  void filter(const Taps& taps, float* out) const {
    const float* const first = &padded_[kMargin] - taps.size() / 2;
    weighted_sum(
        taps, [&](int k) { return first + k; }, stride_, out);
  }

 private:
  static constexpr int kMargin = 16;  ///< the longest filters reach 10 pixels

  int width_, stride_;
  std::vector<float> padded_;
};

}  // namespace spindrift::compare
