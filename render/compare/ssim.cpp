// Computes structural similarity, with the symbols and constants of Wang et al. (2004), section
// III.

#include <cmath>

#include "render/compare/filter.hpp"
#include "render/compare/metrics.hpp"
#include "render/compare/same_size.hpp"

namespace spindrift::compare {
namespace {

constexpr int radius = 5;  // radius of the windows, pixels

Taps<double> gaussian() {
  Taps<double> taps;
  double sum = 0;
  for (int k = -radius; k <= radius; ++k)
    sum += taps.emplace_back(std::exp(-k * k / (2. * 1.5 * 1.5)));
  for (double& tap : taps)
    tap /= sum;
  return taps;
}

/// Returns the BT.601 luma of a pixel, 0 ... 1.
double luma(const std::uint8_t* pixel) {
  return (0.299 * pixel[0] + 0.587 * pixel[1] + 0.114 * pixel[2]) / 255.;
}

/// Returns the similarity of two windows, given their means of x, y, x² + y² and xy (equation 13).
double similarity(double x, double y, double squares, double product) {
  constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
  const double covariance = product - x * y, variances = squares - (x * x + y * y);
  return (2. * (x * y) + c1) * (2. * covariance + c2) / ((x * x + y * y + c1) * (variances + c2));
}

}  // namespace

double ssim(const Image& a, const Image& b) {
  require_same_size(a, b);
  static const Taps<double> taps = gaussian();
  const int w = a.width, h = a.height;
  Plane<double> x(w, h), y(w, h), squares(w, h), products(w, h);
#pragma omp parallel for schedule(static)
  for (int j = 0; j < h; ++j) {
    double *const px = x.row(j), *const py = y.row(j), *const s = squares.row(j),
                  *const p = products.row(j);
    for (int i = 0; i < w; ++i) {
      const std::size_t at = (std::size_t(j) * w + i) * 3;
      px[i] = luma(&a.pixels[at]);
      py[i] = luma(&b.pixels[at]);
      s[i] = px[i] * px[i] + py[i] * py[i];
      p[i] = px[i] * py[i];
    }
  }

  // The mean is over the windows that lie wholly in the picture; in a small picture, over those in
  // its middle.
  const int left = std::min(radius, (w - 1) / 2), top = std::min(radius, (h - 1) / 2);
  std::vector<double> row_sums(std::size_t(h), 0.);
#pragma omp parallel
  {
    RowFilter<double> row(w);
    const auto length = static_cast<std::size_t>(padded_width(w));
    std::vector<double> mean_x(length), mean_y(length), mean_squares(length), mean_products(length);
#pragma omp for schedule(static)
    for (int j = top; j < h - top; ++j) {
      const auto filter = [&](const Plane<double>& plane, std::vector<double>& out) {
        row.set(plane, j, taps);
        row.filter(taps, out.data());
      };
      filter(x, mean_x);
      filter(y, mean_y);
      filter(squares, mean_squares);
      filter(products, mean_products);
      for (std::size_t i = std::size_t(left); i < std::size_t(w - left); ++i)
        row_sums[std::size_t(j)] +=
            similarity(mean_x[i], mean_y[i], mean_squares[i], mean_products[i]);
    }
  }
  double sum = 0;
  for (const double row : row_sums)
    sum += row;
  return sum / (double(w - 2 * left) * (h - 2 * top));
}

}  // namespace spindrift::compare
