// Measures how far two pictures are apart: PSNR, SSIM, FLIP and the share of pixels that changed.
// All metrics are the same with the pictures exchanged, and the same for every thread count.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "render/image.hpp"

namespace spindrift::compare {

/// Threshold beyond which a pixel has changed: the largest difference of its channels, of 255.
inline constexpr int default_threshold = 16;

/// The percentiles that are reported of FLIP.
inline constexpr std::array<int, 5> flip_percentiles{50, 75, 90, 95, 99};

/// FLIP over all pixels: 0 where pictures look the same, 1 where they could not differ more.
struct FlipSummary {
  double mean = 0;
  std::array<double, flip_percentiles.size()> percentiles{};  ///< rounded up to 0.0001
  double max = 0;
};

/// How far one pair of pictures, or many together, are apart.
struct Metrics {
  /// Peak signal-to-noise ratio over all channels, dB; infinite for equal pictures.
  double psnr = 0;
  double ssim = 0;  ///< structural similarity of luma, mean over pictures; 1 for equal pictures
  FlipSummary flip;
  double changed = 0;  ///< share of the pixels beyond the threshold, 0 ... 1
};

/// Sums of one or more pairs of pictures, from which their metrics follow.
class Tally {
 public:
  /// Adds a pair of pictures of the same size.
  /// @param flip      FLIP of every pixel, 0 ... 1
  /// @param ssim      mean structural similarity of the pair
  /// @param threshold largest difference of channels, of 255, at which a pixel has not changed
  void add(const Image& a, const Image& b, const std::vector<float>& flip, double ssim,
           int threshold);
  /// Adds all pairs of another tally.
  void add(const Tally& more);
  /// Returns the metrics of all pairs together.
  /// @throws std::logic_error where nothing was added
  Metrics metrics() const;

 private:
  static constexpr int flip_bins = 10000;

  std::int64_t pictures_ = 0;
  std::int64_t pixels_ = 0;
  std::int64_t changed_ = 0;
  std::uint64_t squared_error_ = 0;  ///< over all channels, in steps of 1/255
  double ssim_sum_ = 0;
  double flip_sum_ = 0;
  float flip_max_ = 0;
  std::vector<std::int64_t> flip_histogram_ = std::vector<std::int64_t>(flip_bins + 1);
};

/// What compare() finds about a pair of pictures.
struct Comparison {
  Tally tally;              ///< the pair's sums
  std::vector<float> flip;  ///< FLIP of every pixel, rows from top to bottom
};

/// Compares a pair of pictures by all metrics.
/// @throws std::invalid_argument for pictures that are empty or differ in size
Comparison compare(const Image& a, const Image& b, int threshold = default_threshold);

/// Returns FLIP of every pixel, rows from top to bottom: Andersson et al., "FLIP: A Difference
/// Evaluator for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020; for
/// pictures of low dynamic range, seen with 67 pixels per degree (a 0.7 m wide screen of 3840
/// pixels from 0.7 m).
/// @throws std::invalid_argument as compare() does
std::vector<float> flip(const Image& a, const Image& b);

/// Returns the mean structural similarity: Wang et al., "Image Quality Assessment: From Error
/// Visibility to Structural Similarity", IEEE Trans. Image Process. 13(4), 2004; of luma (BT.601),
/// with a Gaussian of sigma 1.5 in windows of 11x11 pixels, over the windows that lie wholly in the
/// picture (in pictures of less than 11 pixels, the middle ones, with edges repeated outwards).
/// @throws std::invalid_argument as compare() does
double ssim(const Image& a, const Image& b);

/// Returns a picture of values 0 ... 1, rows from top to bottom, in the colour map "magma": from
/// black to light yellow, growing in lightness throughout.
Image magma(const std::vector<float>& values, int width, int height);

}  // namespace spindrift::compare
