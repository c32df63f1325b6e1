// The metrics against cases made by hand, their published properties, a slow reference in double
// precision, and numbers of other programs.
#include <omp.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <glm/glm.hpp>
#include <limits>
#include <numeric>

#include "output_support.hpp"
#include "render/compare/metrics.hpp"

namespace compare_tests {

using namespace spindrift;
using namespace spindrift::compare;
using namespace spindrift::output_test;

namespace {

Metrics measure(const Image& a, const Image& b, int threshold = default_threshold) {
  return compare::compare(a, b, threshold).tally.metrics();
}

void set_pixel(Image& image, int x, int y, int r, int g, int b) {
  const std::size_t at = 3 * (std::size_t(y) * image.width + x);
  image.pixels[at] = std::uint8_t(r);
  image.pixels[at + 1] = std::uint8_t(g);
  image.pixels[at + 2] = std::uint8_t(b);
}

double mean_of(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.) / double(values.size());
}

// --- FLIP by its definition: two-dimensional filters, double precision, one pixel at a time.

using Field = std::vector<double>;
constexpr double pi = 3.14159265358979323846, per_degree = 67;

struct Kernel {
  int radius;
  Field weights;
};

template <class Weight>
Kernel kernel_of(int radius, const Weight& weight) {
  Kernel kernel{radius, {}};
  for (int y = -radius; y <= radius; ++y)
    for (int x = -radius; x <= radius; ++x)
      kernel.weights.push_back(weight(x, y));
  double positive = 0, negative = 0;
  for (const double w : kernel.weights)
    (w > 0 ? positive : negative) += std::abs(w);
  for (double& w : kernel.weights)
    w /= w > 0 ? positive : negative;
  return kernel;
}

Field filtered(const Field& field, int width, int height, const Kernel& kernel) {
  Field result(field.size());
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      std::size_t k = 0;
      for (int j = y - kernel.radius; j <= y + kernel.radius; ++j)
        for (int i = x - kernel.radius; i <= x + kernel.radius; ++i)
          result[std::size_t(y * width + x)] +=
              kernel.weights[k++] * field[std::size_t(std::clamp(j, 0, height - 1) * width +
                                                      std::clamp(i, 0, width - 1))];
    }
  return result;
}

const glm::dmat3 to_xyz =
    glm::transpose(glm::dmat3(10135552. / 24577794, 8788810. / 24577794, 4435075. / 24577794,
                              2613072. / 12288897, 8788810. / 12288897, 887015. / 12288897,
                              1425312. / 73733382, 8788810. / 73733382, 70074185. / 73733382));
const glm::dvec3 white = to_xyz * glm::dvec3(1);

glm::dvec3 hunt_lab(const glm::dvec3& rgb) {
  const auto f = [](double t) { return t > 216. / 24389 ? std::cbrt(t) : t * 841 / 108 + 4. / 29; };
  const glm::dvec3 t = to_xyz * rgb / white;
  const double l = 116 * f(t.y) - 16;
  return {l, 5 * l * (f(t.x) - f(t.y)), 2 * l * (f(t.y) - f(t.z))};
}

double hyab(const glm::dvec3& p, const glm::dvec3& q) {
  return std::abs(p.x - q.x) + std::hypot(p.y - q.y, p.z - q.z);
}

/// Of two colours in linear light, each all over its picture.
double color_error(const glm::dvec3& p, const glm::dvec3& q) {
  const double most = std::pow(hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7);
  const double error = std::pow(hyab(hunt_lab(p), hunt_lab(q)), 0.7);
  return error < 0.4 * most ? 0.95 / (0.4 * most) * error
                            : 0.95 + (error - 0.4 * most) / (0.6 * most) * 0.05;
}

glm::dvec3 linear(int r, int g, int b) {
  const auto one = [](int value) {
    const double v = value / 255.;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return {one(r), one(g), one(b)};
}

/// A picture as FLIP sees it.
struct Seen {
  std::vector<glm::dvec3> rgb;  ///< linear, after the filters
  Field edges, points;
};

Seen seen(const Image& image) {
  const int w = image.width, h = image.height;
  Field y, cx, cz;
  for (std::size_t i = 0; i < image.pixels.size(); i += 3) {
    const glm::dvec3 t =
        to_xyz * linear(image.pixels[i], image.pixels[i + 1], image.pixels[i + 2]) / white;
    y.push_back(t.y);
    cx.push_back(500 * (t.x - t.y));
    cz.push_back(200 * (t.y - t.z));
  }
  const auto sensitivity = [](double a1, double b1, double a2, double b2) {
    return kernel_of(10, [=](int i, int j) {
      const double d2 = (i * i + j * j) / (per_degree * per_degree);
      return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * d2 / b1) +
             a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * d2 / b2);
    });
  };
  const Field fy = filtered(y, w, h, sensitivity(1, 0.0047, 0, 1));
  const Field fx = filtered(cx, w, h, sensitivity(1, 0.0053, 0, 1));
  const Field fz = filtered(cz, w, h, sensitivity(34.1, 0.04, 13.5, 0.025));
  Seen result;
  for (std::size_t i = 0; i < y.size(); ++i)
    result.rgb.push_back(
        glm::clamp(glm::inverse(to_xyz) *
                       (white * glm::dvec3(fy[i] + fx[i] / 500, fy[i], fy[i] - fz[i] / 200)),
                   0., 1.));
  const double s = 0.5 * 0.082 * per_degree;
  const auto strength = [&](const auto& along) {
    const auto g = [&](int i, int j) { return std::exp(-(i * i + j * j) / (2 * s * s)); };
    const Field gx =
        filtered(y, w, h, kernel_of(9, [&](int i, int j) { return along(i) * g(i, j); }));
    const Field gy =
        filtered(y, w, h, kernel_of(9, [&](int i, int j) { return along(j) * g(i, j); }));
    Field length;
    for (std::size_t i = 0; i < gx.size(); ++i)
      length.push_back(std::hypot(gx[i], gy[i]));
    return length;
  };
  result.edges = strength([](int i) { return -double(i); });
  result.points = strength([&](int i) { return i * i / (s * s) - 1; });
  return result;
}

Field slow_flip(const Image& a, const Image& b) {
  const Seen p = seen(a), q = seen(b);
  Field errors;
  for (std::size_t i = 0; i < p.rgb.size(); ++i) {
    const double feature =
        std::max(std::abs(p.edges[i] - q.edges[i]), std::abs(p.points[i] - q.points[i]));
    errors.push_back(std::pow(color_error(p.rgb[i], q.rgb[i]),
                              1 - std::min(1., std::sqrt(feature / std::sqrt(2.)))));
  }
  return errors;
}

}  // namespace

TEST_CASE("equal pictures are equal by every metric") {
  for (const Image& image : {noise(64, 40, 1), solid(3, 2, 10, 200, 30), waves(50, 31, 0.5)}) {
    const Metrics m = measure(image, image);
    CHECK(m.psnr == std::numeric_limits<double>::infinity());
    CHECK(m.ssim == 1);
    CHECK(m.flip.mean == 0);
    CHECK(m.flip.max == 0);
    CHECK(m.flip.percentiles.back() == 0);
    CHECK(m.changed == 0);
  }
}

TEST_CASE("no metric asks which picture is which, and all stay within their bounds") {
  for (const auto& [a, b] : {std::pair(noise(70, 41, 1), waves(70, 41, 0)),
                             std::pair(solid(20, 20, 0, 255, 0), solid(20, 20, 0, 0, 255)),
                             std::pair(solid(9, 30, 0, 0, 0), solid(9, 30, 255, 255, 255))}) {
    const Metrics m = measure(a, b), n = measure(b, a);
    CHECK(m.psnr == n.psnr);
    CHECK(m.ssim == n.ssim);
    CHECK(flip(a, b) == flip(b, a));
    CHECK((m.ssim >= -1 && m.ssim < 1));
    CHECK((m.flip.mean > 0 && m.flip.max <= 1));
    CHECK(m.flip.mean <= m.flip.max);
    CHECK(m.flip.percentiles.back() <= m.flip.max + 1e-4);
    CHECK(m.flip.percentiles[0] <= m.flip.percentiles[1]);
  }
}

TEST_CASE("no two colours are farther apart than FLIP can count") {
  for (int p = 0; p < 8; ++p)
    for (int q = 0; q < 8; ++q) {
      const auto corner = [](int k) {
        return solid(2, 2, 255 * (k & 1), 255 * (k >> 1 & 1), 255 * (k >> 2));
      };
      const Metrics m = measure(corner(p), corner(q));
      CHECK(m.flip.max <= 1);
      CHECK(m.flip.percentiles.back() <= 1);
      CHECK((m.flip.mean > 0.1) == (p != q));
    }
}

TEST_CASE("PSNR and the share of changed pixels are what one can count") {
  // One of 100 pixels is off by 17 in one channel: the mean squared error is 17² / 300.
  const Image a = solid(10, 10, 100, 100, 100);
  Image b = a;
  set_pixel(b, 4, 5, 100, 117, 100);
  CHECK(measure(a, b).psnr == Approx(10 * std::log10(255. * 255 * 300 / 289)).epsilon(1e-12));
  CHECK(measure(a, b).changed == 0.01);
  CHECK(measure(a, b, 17).changed == 0);
  CHECK(measure(solid(8, 8, 0, 0, 0), solid(8, 8, 255, 255, 255)).psnr == 0);
}

TEST_CASE("SSIM of two plain pictures is that of their luma alone") {
  const double x = 100 / 255., y = 150 / 255., c1 = 1e-4;
  CHECK(ssim(solid(40, 30, 100, 100, 100), solid(40, 30, 150, 150, 150)) ==
        Approx((2 * x * y + c1) / (x * x + y * y + c1)).margin(1e-5));
  // The negative of a chequered picture has its means, and the opposite covariance.
  Image board(30, 30), negative(30, 30);
  for (int k = 0; k < 900; ++k) {
    const bool light = (k % 30 + k / 30) % 2 == 0;
    set_pixel(board, k % 30, k / 30, light ? 255 : 0, light ? 255 : 0, light ? 255 : 0);
    set_pixel(negative, k % 30, k / 30, light ? 0 : 255, light ? 0 : 255, light ? 0 : 255);
  }
  const double v = 0.25, c2 = 9e-4;
  CHECK(ssim(board, negative) == Approx((-2 * v + c2) / (2 * v + c2)).margin(1e-4));
}

TEST_CASE("SSIM is that of scikit-image") {
  // structural_similarity(gaussian_weights=True, sigma=1.5, use_sample_covariance=False,
  // data_range=255) of scikit-image 0.26 on the luma.
  CHECK(ssim(waves(160, 90, 0), waves(160, 90, 0.3)) == Approx(0.7953266).margin(1e-5));
  CHECK(ssim(noise(47, 33, 7), waves(47, 33, 0)) == Approx(0.0088533).margin(1e-5));
}

TEST_CASE("FLIP of two plain colours is the distance of the colours") {
  // Green and blue are the farthest apart of all: their distance is 1 by definition.
  const auto green_blue = flip(solid(30, 20, 0, 255, 0), solid(30, 20, 0, 0, 255));
  CHECK(mean_of(green_blue) == Approx(1).margin(1e-6));
  for (const glm::ivec3 c : {glm::ivec3(120, 30, 200), glm::ivec3(3, 4, 5), glm::ivec3(250)}) {
    const auto errors = flip(solid(30, 20, c.x, c.y, c.z), solid(30, 20, 90, 100, 110));
    const double expected = color_error(linear(c.x, c.y, c.z), linear(90, 100, 110));
    for (const float error : errors)
      CHECK(error == Approx(expected).margin(2e-5));
  }
}

TEST_CASE("FLIP is what its definition says, pixel by pixel") {
  Image dot = solid(47, 33, 128, 128, 128);
  set_pixel(dot, 20, 15, 255, 255, 255);
  for (const auto& [a, b] : {std::pair(noise(47, 33, 7), waves(47, 33, 0)),
                             std::pair(waves(47, 33, 0), waves(47, 33, 0.1)),
                             std::pair(dot, solid(47, 33, 128, 128, 128))}) {
    const std::vector<float> fast = flip(a, b);
    const Field slow = slow_flip(a, b);
    double worst = 0;
    for (std::size_t i = 0; i < fast.size(); ++i)
      worst = std::max(worst, std::abs(fast[i] - slow[i]));
    CHECK(worst < 2e-4);  // floats: small differences of edges go through a root
    CHECK(std::abs(mean_of(fast) -
                   std::accumulate(slow.begin(), slow.end(), 0.) / double(slow.size())) < 2e-6);
  }
}

TEST_CASE("FLIP is NVIDIA's, to 1e-4") {
  // flip-evaluator 1.7, evaluate(..., "LDR"), 67 pixels per degree.
  CHECK(mean_of(flip(waves(160, 90, 0), waves(160, 90, 0.3))) == Approx(0.1657469).margin(1e-4));
  CHECK(mean_of(flip(noise(47, 33, 7), waves(47, 33, 0))) == Approx(0.7983092).margin(1e-4));
}

TEST_CASE("percentiles are those of the sorted values, for pairs alone and together") {
  Image a = solid(100, 1, 0, 0, 0);
  const std::vector<float> values = [] {
    std::vector<float> list;
    for (int i = 0; i < 100; ++i)
      list.push_back(0.01f * float((i * 37) % 100));
    return list;
  }();
  Tally tally;
  tally.add(a, a, values, 1, 0);
  const Metrics one = tally.metrics();
  CHECK(one.flip.percentiles[0] == Approx(0.49).margin(1e-4));
  CHECK(one.flip.percentiles[4] == Approx(0.98).margin(1e-4));
  CHECK(one.flip.max == Approx(0.99));
  CHECK(one.flip.mean == Approx(0.495));
  Tally zeros;
  zeros.add(a, a, std::vector<float>(100), 0.5, 0);
  tally.add(zeros);
  const Metrics both = tally.metrics();
  CHECK(both.flip.percentiles[0] == Approx(0).margin(1e-4));
  CHECK(both.flip.percentiles[3] == Approx(0.89).margin(1e-4));
  CHECK(both.flip.mean == Approx(0.2475));
  CHECK(both.ssim == 0.75);
  CHECK_THROWS_AS(Tally().metrics(), std::logic_error);
}

TEST_CASE("metrics are the same for every thread count") {
  const Image a = waves(123, 77, 0), b = waves(123, 77, 0.2);
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const auto flip_one = flip(a, b);
  const double ssim_one = ssim(a, b);
  for (const int threads : {2, 4}) {
    omp_set_num_threads(threads);
    CHECK(flip(a, b) == flip_one);
    CHECK(ssim(a, b) == ssim_one);
  }
  omp_set_num_threads(before);
}

TEST_CASE("pictures of unequal size are refused with their sizes") {
  CHECK_THROWS_WITH(compare::compare(Image(4, 3), Image(4, 2)),
                    Catch::Contains("4x3") && Catch::Contains("4x2"));
  CHECK_THROWS_AS(flip(Image(), Image()), std::invalid_argument);
}

TEST_CASE("the colour map grows lighter throughout, from black to light yellow") {
  std::vector<float> values(257);
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = float(i) / 256;
  const Image map = magma(values, 257, 1);
  double before = -1;
  for (std::size_t i = 0; i < map.pixels.size(); i += 3) {
    const glm::dvec3 rgb = linear(map.pixels[i], map.pixels[i + 1], map.pixels[i + 2]);
    const double luminance = (to_xyz * rgb).y;
    CHECK(luminance >= before);
    before = luminance;
  }
  CHECK((map.pixels[0] == 0 && map.pixels[2] == 4));
  CHECK((map.pixels[768] == 252 && map.pixels[769] == 253 && map.pixels[770] == 191));
}

}  // namespace compare_tests
