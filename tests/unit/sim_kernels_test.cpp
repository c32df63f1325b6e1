// The kernels by their properties: integral one, gradient and Laplacian against finite differences,
// zero outside the support, eight lanes like one.
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "sim/core/diffusion.hpp"
#include "sim/core/kernels.hpp"
#include "sim/core/lattice.hpp"

namespace sim_kernels_tests {

using namespace spindrift::sim;

namespace {

constexpr float radius = 0.1f;

/// ∫ W over the ball of the support radius, by the midpoint rule over spherical shells.
template <class Kernel>
double integral(const Kernel& kernel) {
  constexpr int shells = 4000;
  const double h = double{radius} / shells;
  double sum = 0;
  for (int k = 0; k < shells; ++k) {
    const double r = (k + 0.5) * h;
    sum += 4 * std::numbers::pi * r * r * h * double{kernel.value(static_cast<float>(r))};
  }
  return sum;
}

/// dW/dr by central differences.
template <class Kernel>
double slope(const Kernel& kernel, double r) {
  const double h = 1e-3 * radius;
  return (double{kernel.value(static_cast<float>(r + h))} -
          double{kernel.value(static_cast<float>(r - h))}) /
         (2 * h);
}

template <class Kernel>
void check_gradient(const Kernel& kernel) {
  const double scale = std::abs(slope(kernel, 0.25 * radius));
  for (double q = 0.05; q < 0.99; q += 0.05) {
    const double r = q * radius;
    CHECK(double{kernel.gradient(static_cast<float>(r))} * r ==
          Approx(slope(kernel, r)).margin(2e-3 * scale));
  }
}

}  // namespace

TEST_CASE("every kernel integrates to one") {
  CHECK(integral(CubicKernel(radius)) == Approx(1).epsilon(1e-4));
  CHECK(integral(SpikyKernel(radius)) == Approx(1).epsilon(1e-4));
}

TEST_CASE("kernel gradients are the slopes of the kernels") {
  check_gradient(CubicKernel(radius));
  check_gradient(SpikyKernel(radius));
}

TEST_CASE("the Laplacian of a square is six on a lattice, and nearly on rows that have slid") {
  constexpr float spacing = 0.5f * radius;
  const DiffusionKernel kernel(spacing, radius);
  for (const float slide : {0.f, 0.25f, 0.5f}) {
    double laplacian = 0;
    for (int i = -3; i <= 3; ++i)
      for (int j = -3; j <= 3; ++j)
        for (int k = -3; k <= 3; ++k) {
          const float shift = i % 2 == 0 ? 0.f : slide;
          const glm::vec3 x =
              spacing * glm::vec3(i, static_cast<float>(j) + shift, static_cast<float>(k));
          laplacian += double{kernel.weight(glm::dot(x, x))} * glm::dot(x, x);
        }
    CHECK(laplacian == Approx(6).epsilon(slide == 0 ? 1e-5 : 0.07));
  }
}

TEST_CASE("kernels and their gradients vanish from the support radius on") {
  for (const float r : {radius, 1.5f * radius, 1e15f}) {
    CHECK(CubicKernel(radius).value(r) == 0.f);
    CHECK(CubicKernel(radius).gradient(r) == 0.f);
    CHECK(SpikyKernel(radius).value(r) == 0.f);
    CHECK(SpikyKernel(radius).gradient(r) == 0.f);
    CHECK(DiffusionKernel(0.5f * radius, radius).weight(r * r) == 0.f);
  }
}

TEST_CASE("gradients are finite where two particles are at the same place") {
  CHECK(std::isfinite(CubicKernel(radius).gradient(0.f)));
  CHECK(SpikyKernel(radius).gradient(0.f) == 0.f);
}

TEST_CASE("eight lanes give the same bits as one number") {
  const CubicKernel cubic(radius);
  const SpikyKernel spiky(radius);
  const DiffusionKernel diffusion(0.5f * radius, radius);
  Lanes r;
  for (int k = 0; k < lane_count; ++k)
    r[k] = radius * 0.15f * static_cast<float>(k);
  const Lanes w = cubic.value(r), g = cubic.gradient(r), s = spiky.gradient(r),
              l = diffusion.weight(r * r);
  const Lanes root = square_root(r);
  for (int k = 0; k < lane_count; ++k) {
    CHECK(w[k] == cubic.value(float{r[k]}));
    CHECK(g[k] == cubic.gradient(float{r[k]}));
    CHECK(s[k] == spiky.gradient(float{r[k]}));
    CHECK(l[k] == diffusion.weight(float{r[k]} * float{r[k]}));
    CHECK(root[k] == square_root(float{r[k]}));
  }
}

TEST_CASE("a full lattice has the rest density, no net gradient and 27 points within the support") {
  constexpr float spacing = 0.5f * radius;
  const CubicKernel kernel(radius);
  CHECK(1 / lattice_kernel_sum(kernel, spacing, radius) ==
        Approx(std::pow(spacing, 3)).epsilon(0.01));
  Vec3<float> gradient{0, 0, 0};
  int visited = 0;
  for_lattice_points(spacing, radius, [&](const Vec3<float>& p) {
    gradient += kernel.gradient(square_root(dot(p, p))) * p;
    ++visited;
  });
  // In units of one neighbour's gradient.
  const float one = std::abs(kernel.gradient(spacing)) * spacing;
  CHECK(std::abs(gradient.x) + std::abs(gradient.y) + std::abs(gradient.z) < 1e-5f * one);
  // Squares of whole numbers that add up to less than 4: 0 once, 1 six times, 2 twelve, 3 eight.
  CHECK(visited == 1 + 6 + 12 + 8);
  const double at[] = {6. * 1, 12. * 2, 8. * 3};
  double product = 0;
  for (int k = 0; k < 3; ++k)
    product += at[k] * std::pow(double{kernel.gradient(spacing * std::sqrt(float(k + 1)))}, 2);
  CHECK(lattice_gradient_product(kernel, kernel, spacing, radius) ==
        Approx(product * spacing * spacing).epsilon(1e-6));
}

}  // namespace sim_kernels_tests
