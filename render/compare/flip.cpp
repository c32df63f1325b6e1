// Computes FLIP of pictures of low dynamic range. Symbols and constants are those of Andersson et
// al. (2020), sections 4.1 (colours) and 4.2 (edges and points).

#include <array>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>
#include <numeric>

#include "render/compare/filter.hpp"
#include "render/compare/metrics.hpp"
#include "render/compare/same_size.hpp"

namespace spindrift::compare {
namespace {

constexpr float pi = std::numbers::pi_v<float>;
constexpr float pixels_per_degree = 67.f;

// Matrix from linear sRGB to CIE XYZ (IEC 61966-2-1), given by its rows, and the XYZ of white,
// illuminant D65.
constexpr glm::vec3 to_x{10135552.f / 24577794.f, 8788810.f / 24577794.f, 4435075.f / 24577794.f};
constexpr glm::vec3 to_y{2613072.f / 12288897.f, 8788810.f / 12288897.f, 887015.f / 12288897.f};
constexpr glm::vec3 to_z{1425312.f / 73733382.f, 8788810.f / 73733382.f, 70074185.f / 73733382.f};
const glm::mat3 xyz_of_rgb = glm::transpose(glm::mat3(to_x, to_y, to_z));
const glm::vec3 white = xyz_of_rgb * glm::vec3(1.f);

/// Matrix from linear sRGB to XYZ relative to white, and its inverse.
const glm::mat3 relative_xyz_of_rgb =
    glm::mat3(xyz_of_rgb[0] / white, xyz_of_rgb[1] / white, xyz_of_rgb[2] / white);
const glm::mat3 rgb_of_relative_xyz = glm::inverse(relative_xyz_of_rgb);

/// Returns the linear light, 0 ... 1, of each 8-bit value (IEC 61966-2-1).
const std::array<float, 256>& linear_of_srgb() {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (int i = 0; i < 256; ++i) {
      const double v = i / 255.;
      values[std::size_t(i)] =
          static_cast<float>(v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4));
    }
    return values;
  }();
  return table;
}

/// Returns CIELAB of an XYZ relative to white, with the Hunt effect: colours fade in the dark
/// (equation 4).
glm::vec3 hunt_lab(const glm::vec3& xyz) {
  constexpr float delta = 6.f / 29.f;
  const auto f = [](float t) {
    return t > delta * delta * delta ? std::cbrt(t) : t / (3.f * delta * delta) + 4.f / 29.f;
  };
  const float fx = f(xyz.x), fy = f(xyz.y), fz = f(xyz.z);
  const float lightness = 116.f * fy - 16.f;
  return {lightness, 0.01f * lightness * 500.f * (fx - fy), 0.01f * lightness * 200.f * (fy - fz)};
}

/// Returns the distance of two colours in CIELAB, a measure for large differences (Abasi et al.
/// 2019), raised to the power q_c.
float hyab_power(const glm::vec3& a, const glm::vec3& b) {
  const glm::vec3 d = a - b;
  return std::pow(std::abs(d.x) + std::sqrt(d.y * d.y + d.z * d.z), 0.7f);
}

/// Maps a distance of colours to 0 ... 1, so that the distances of most colours take most of that
/// range (equation 6).
float redistributed(float error) {
  static const float largest = hyab_power(hunt_lab(relative_xyz_of_rgb * glm::vec3(0, 1, 0)),
                                          hunt_lab(relative_xyz_of_rgb * glm::vec3(0, 0, 1)));
  constexpr float p_t = 0.95f;
  const float knee = 0.4f * largest;
  return error < knee ? p_t / knee * error : p_t + (error - knee) / (largest - knee) * (1.f - p_t);
}

/// Returns a 1-D filter, given its weight as a function of the distance in pixels.
template <class Weight>
Taps<float> taps_of(int radius, const Weight& weight) {
  Taps<float> taps;
  for (int k = -radius; k <= radius; ++k)
    taps.push_back(weight(static_cast<float>(k)));
  return taps;
}

float sum_of(const Taps<float>& taps) {
  return std::accumulate(taps.begin(), taps.end(), 0.f);
}

Taps<float> scaled_to_one(Taps<float> taps) {
  const float sum = sum_of(taps);
  for (float& tap : taps)
    tap /= sum;
  return taps;
}

/// Returns the Gaussian of the eye's contrast sensitivity, exp(-pi² d² / b) with d in degrees
/// (equation 2).
Taps<float> sensitivity(float b) {
  // All filters reach as far as 3 standard deviations of the widest, whose b is 0.04.
  const int radius =
      static_cast<int>(std::ceil(3.f * std::sqrt(0.04f / (2.f * pi * pi)) * pixels_per_degree));
  return taps_of(radius, [&](float k) {
    const float degrees = k / pixels_per_degree;
    return std::exp(-pi * pi * degrees * degrees / b);
  });
}

/// Scales positive weights so that they add up to 1, negative ones so that they add up to -1.
Taps<float> scaled_by_sign(Taps<float> taps) {
  float positive = 0, negative = 0;
  for (const float tap : taps)
    (tap > 0 ? positive : negative) += std::abs(tap);
  for (float& tap : taps)
    tap /= tap > 0 ? positive : negative;
  return taps;
}

/// The filters that model what the eye lets through, and those that find edges and points.
struct Filters {
  Taps<float> achromatic = scaled_to_one(sensitivity(0.0047f));
  Taps<float> red_green = scaled_to_one(sensitivity(0.0053f));
  Taps<float> blue_yellow = scaled_to_one(sensitivity(0.04f));
  Taps<float> blue_yellow_narrow = scaled_to_one(sensitivity(0.025f));
  float narrow_share;  ///< share of blue_yellow_narrow in its sum with blue_yellow
  Taps<float> smooth, edge, point;

  Filters() {
    // Returns what a sqrt(pi/b) exp(-pi² d² / b) adds up to in two dimensions.
    const auto volume = [](float a, float b) {
      const float sum = sum_of(sensitivity(b));
      return a * std::sqrt(pi / b) * sum * sum;
    };
    const float wide = volume(34.1f, 0.04f), narrow = volume(13.5f, 0.025f);
    narrow_share = narrow / (wide + narrow);

    const float sigma = 0.5f * 0.082f * pixels_per_degree;  // half a width of 0.082 degrees
    const int radius = static_cast<int>(std::ceil(3.f * sigma));
    const auto gaussian = [&](float k) { return std::exp(-k * k / (2.f * sigma * sigma)); };
    smooth = scaled_to_one(taps_of(radius, gaussian));
    edge = scaled_by_sign(taps_of(radius, [&](float k) { return -k * gaussian(k); }));
    point = scaled_by_sign(
        taps_of(radius, [&](float k) { return (k * k / (sigma * sigma) - 1.f) * gaussian(k); }));
  }
};

/// A picture in linear opponent colours, relative to white: Y, X - Y and Y - Z. These are the
/// paper's YCxCz but for scale and offset, which filters that add up to 1 leave alone.
struct Opponent {
  Plane<float> y, x_y, y_z;

  explicit Opponent(const Image& image)
      : y(image.width, image.height),
        x_y(image.width, image.height),
        y_z(image.width, image.height) {
    const auto& linear = linear_of_srgb();
#pragma omp parallel for schedule(static)
    for (int j = 0; j < image.height; ++j) {
      const std::uint8_t* pixel = &image.pixels[std::size_t(j) * image.width * 3];
      float* const to[3] = {y.row(j), x_y.row(j), y_z.row(j)};
      for (int i = 0; i < image.width; ++i, pixel += 3) {
        const glm::vec3 xyz =
            relative_xyz_of_rgb * glm::vec3(linear[pixel[0]], linear[pixel[1]], linear[pixel[2]]);
        to[0][i] = xyz.y;
        to[1][i] = xyz.x - xyz.y;
        to[2][i] = xyz.y - xyz.z;
      }
    }
  }
};

/// One row of a picture as the eye sees it: colours in CIELAB, and how strong edges and points are.
class SeenRow {
 public:
  SeenRow(const Filters& filters, int width) : filters_(filters), row_(width) {
    for (std::vector<float>* values :
         {&y_, &x_y_, &y_z_, &narrow_, &across_, &along_, &edge_, &point_})
      values->resize(static_cast<std::size_t>(padded_width(width)));
    lab_.resize(static_cast<std::size_t>(width));
  }

  void set(const Opponent& picture, int y) {
    see_colours(picture, y);
    strength(picture, y, filters_.edge, edge_);
    strength(picture, y, filters_.point, point_);
  }

  const glm::vec3& lab(int x) const { return lab_[static_cast<std::size_t>(x)]; }
  float edge(int x) const { return edge_[static_cast<std::size_t>(x)]; }
  float point(int x) const { return point_[static_cast<std::size_t>(x)]; }

 private:
  void filter(const Plane<float>& plane, int y, const Taps<float>& across, const Taps<float>& along,
              std::vector<float>& out) {
    row_.set(plane, y, across);
    row_.filter(along, out.data());
  }

  void see_colours(const Opponent& picture, int y) {
    filter(picture.y, y, filters_.achromatic, filters_.achromatic, y_);
    filter(picture.x_y, y, filters_.red_green, filters_.red_green, x_y_);
    filter(picture.y_z, y, filters_.blue_yellow, filters_.blue_yellow, y_z_);
    filter(picture.y_z, y, filters_.blue_yellow_narrow, filters_.blue_yellow_narrow, narrow_);
    for (std::size_t i = 0; i < lab_.size(); ++i) {
      const float y_z = y_z_[i] + filters_.narrow_share * (narrow_[i] - y_z_[i]);
      const glm::vec3 rgb = rgb_of_relative_xyz * glm::vec3(y_[i] + x_y_[i], y_[i], y_[i] - y_z);
      lab_[i] = hunt_lab(relative_xyz_of_rgb * glm::clamp(rgb, 0.f, 1.f));
    }
  }

  /// Sets `out` to the length of the vector of the derivatives of luminance along and across rows.
  void strength(const Opponent& picture, int y, const Taps<float>& derivative,
                std::vector<float>& out) {
    filter(picture.y, y, filters_.smooth, derivative, along_);
    filter(picture.y, y, derivative, filters_.smooth, across_);
    for (std::size_t i = 0; i < out.size(); ++i)
      out[i] = std::sqrt(along_[i] * along_[i] + across_[i] * across_[i]);
  }

  const Filters& filters_;
  RowFilter<float> row_;
  std::vector<float> y_, x_y_, y_z_, narrow_, across_, along_, edge_, point_;
  std::vector<glm::vec3> lab_;
};

}  // namespace

std::vector<float> flip(const Image& a, const Image& b) {
  require_same_size(a, b);
  static const Filters filters;
  const Opponent first(a), second(b);
  std::vector<float> errors(static_cast<std::size_t>(a.width) * a.height);
#pragma omp parallel
  {
    SeenRow p(filters, a.width), q(filters, a.width);
#pragma omp for schedule(static)
    for (int y = 0; y < a.height; ++y) {
      p.set(first, y);
      q.set(second, y);
      for (int x = 0; x < a.width; ++x) {
        const float color = redistributed(hyab_power(p.lab(x), q.lab(x)));
        const float feature =
            std::max(std::abs(p.edge(x) - q.edge(x)), std::abs(p.point(x) - q.point(x)));
        const float sharpened = std::min(1.f, std::sqrt(feature / std::numbers::sqrt2_v<float>));
        errors[std::size_t(y) * a.width + x] = std::min(1.f, std::pow(color, 1.f - sharpened));
      }
    }
  }
  return errors;
}

}  // namespace spindrift::compare
