#include "render/compare/metrics.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <string>

#include "render/compare/same_size.hpp"

namespace spindrift::compare {

void require_same_size(const Image& a, const Image& b) {
  const auto size = [](const Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height) + " pixels";
  };
  if (a.width != b.width || a.height != b.height || a.pixels.size() != b.pixels.size() ||
      a.pixels.empty())
    throw std::invalid_argument("pictures of " + size(a) + " and of " + size(b) +
                                " can't be compared");
}

void Tally::add(const Image& a, const Image& b, const std::vector<float>& flip, double ssim,
                int threshold) {
  for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
    int largest = 0;
    for (std::size_t c = i; c < i + 3; ++c) {
      const int delta = std::abs(int{a.pixels[c]} - int{b.pixels[c]});
      largest = std::max(largest, delta);
      squared_error_ += static_cast<std::uint64_t>(delta * delta);
    }
    changed_ += largest > threshold;
  }
  for (const float value : flip) {
    flip_sum_ += value;
    flip_max_ = std::max(flip_max_, value);
    ++flip_histogram_[static_cast<std::size_t>(std::ceil(std::clamp(value, 0.f, 1.f) * flip_bins))];
  }
  pixels_ += static_cast<std::int64_t>(flip.size());
  ssim_sum_ += ssim;
  ++pictures_;
}

void Tally::add(const Tally& more) {
  pictures_ += more.pictures_;
  pixels_ += more.pixels_;
  changed_ += more.changed_;
  squared_error_ += more.squared_error_;
  ssim_sum_ += more.ssim_sum_;
  flip_sum_ += more.flip_sum_;
  flip_max_ = std::max(flip_max_, more.flip_max_);
  for (std::size_t i = 0; i < flip_histogram_.size(); ++i)
    flip_histogram_[i] += more.flip_histogram_[i];
}

Metrics Tally::metrics() const {
  if (pictures_ == 0)
    throw std::logic_error("metrics of no pictures");
  const auto pixels = static_cast<double>(pixels_);
  Metrics m;
  m.psnr = 10. * std::log10(255. * 255. * 3. * pixels / static_cast<double>(squared_error_));
  m.ssim = ssim_sum_ / static_cast<double>(pictures_);
  m.changed = static_cast<double>(changed_) / pixels;
  m.flip.mean = flip_sum_ / pixels;
  m.flip.max = flip_max_;
  std::int64_t below = 0;
  std::size_t k = 0;
  for (int bin = 0; bin <= flip_bins; ++bin) {
    below += flip_histogram_[static_cast<std::size_t>(bin)];
    for (; k < flip_percentiles.size() && 100 * below >= flip_percentiles[k] * pixels_; ++k)
      m.flip.percentiles[k] = static_cast<double>(bin) / flip_bins;
  }
  return m;
}

Comparison compare(const Image& a, const Image& b, int threshold) {
  Comparison result;
  result.flip = flip(a, b);
  result.tally.add(a, b, result.flip, ssim(a, b), threshold);
  return result;
}

}  // namespace spindrift::compare
