// Surface tension's forces against the energy that they are the gradient of.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "sim/boundary/neighbourhood.hpp"
#include "sim/forces/surface_tension.hpp"
#include "sim/start/initial.hpp"

namespace sim_tension_tests {

using namespace spindrift::sim;
using glm::dvec3;

namespace {

constexpr double d = 0.05, support = 2 * d;

double weight(double r) {
  return r < support ? std::pow(1 - r * r / (support * support), 3) : 0;
}

dvec3 slope(const dvec3& r) {
  const double t = 1 - glm::dot(r, r) / (support * support);
  return t > 0 ? -6 / (support * support) * t * t * r : dvec3(0);
}

/// Σ w over a full lattice, particles at their own place included.
double lattice_sum() {
  double sum = 0;
  for (int x = -2; x <= 2; ++x)
    for (int y = -2; y <= 2; ++y)
      for (int z = -2; z <= 2; ++z)
        sum += weight(d * std::sqrt(x * x + y * y + z * z));
  return sum;
}

struct Wall {
  dvec3 position;
  double part;  ///< of a particle that the sample counts as
};

/// E as it is written, J.
double energy(const std::vector<dvec3>& x, const std::vector<Wall>& walls, double tension) {
  const double scale = 1 / lattice_sum();
  double sum = 0;
  for (const dvec3& at : x) {
    double c = 0;
    dvec3 gradient(0);
    for (const dvec3& other : x) {
      c += weight(glm::distance(at, other));
      gradient += slope(at - other);
    }
    for (const Wall& w : walls) {
      c += w.part * weight(glm::distance(at, w.position));
      gradient += w.part * slope(at - w.position);
    }
    const double lack = std::max(0., 1 - scale * c);
    sum += SurfaceTension::lack_weight * lack * lack +
           SurfaceTension::gradient_weight * d * d * scale * scale * glm::dot(gradient, gradient);
  }
  return tension * d * d * sum;
}

}  // namespace

TEST_CASE("surface tension is the gradient of its energy, and keeps both momenta", "[slow]") {
  const float angle = GENERATE(90.f, 120.f, 180.f);
  Settings s;
  s.fluid.spacing = static_cast<float>(d);
  s.fluid.surface_tension = 0.5f;
  s.fluid.contact_angle = angle;
  s.fluid.volumes = {{Sphere{{0.2f, 0.19f, 0.2f}, 0.18f}}};
  s.domain = {{0, 0, 0}, {1, 1, 1}};
  const FluidConstants constants = constants_of(s.fluid);
  const float radius = 1.05f * constants.support_radius;
  const GridMap map = GridMap::over({-0.1f, -0.1f, -0.1f}, {1.1f, 1.1f, 1.1f}, radius);
  Boundary boundary(s, map, constants.support_radius, nullptr);
  Neighbourhood neighbourhood(map, boundary);
  Executor executor;
  Particles particles;
  const InitialParticles initial = fill_volumes(s);
  particles.resize(static_cast<std::uint32_t>(initial.positions.size()));
  std::mt19937 random(7);
  std::uniform_real_distribution<float> jitter(-0.01f, 0.01f);
  for (std::uint32_t i = 0; i < particles.count; ++i) {
    const Vec3<float> p = from_glm(initial.positions[i]);
    particles.drifted_position.view().set(
        i, {p.x + jitter(random), p.y + jitter(random), p.z + jitter(random)});
  }
  neighbourhood.update(executor, particles, radius);
  std::vector<dvec3> x;
  for (std::uint32_t i = 0; i < particles.count; ++i)
    x.push_back(particles.drifted_position.at(i));
  const double free_part =
      std::sqrt(std::max(0., -std::cos(double{angle} * std::numbers::pi / 180)));
  std::vector<Wall> walls;
  for (std::uint32_t b = 0; b < boundary.count(); ++b) {
    const Vec3<float> p = boundary.positions()[b];
    walls.push_back({{p.x, p.y, p.z}, (1 - free_part) * boundary.volume(b) / constants.volume});
  }
  SurfaceTension(constants).apply({.executor = executor,
                                   .particles = particles,
                                   .constants = constants,
                                   .neighbours = neighbourhood.fluid(),
                                   .boundary = neighbourhood.boundary(),
                                   .grid = neighbourhood.grid(),
                                   .map = &map,
                                   .contact = {{0, 0, 0}, {1, 1, 1}},
                                   .held = nullptr,
                                   .duration = 1e-9,
                                   .refusals = 0,
                                   .kick = 1,
                                   .acceleration = 0});
  const double mass = double{constants.rest_density} * constants.volume;
  dvec3 momentum(0), turning(0);
  double largest = 0;
  for (std::uint32_t i = 0; i < particles.count; ++i) {
    const dvec3 force = mass * dvec3(particles.acceleration.at(i));
    momentum += force;
    turning += glm::cross(x[i], force);
    largest = std::max(largest, glm::length(force));
  }
  for (std::uint32_t i = 0; i < particles.count; i += 17)
    for (int k = 0; k < 3; ++k) {
      constexpr double step = 1e-6;
      std::vector<dvec3> up = x, down = x;
      up[i][k] += step;
      down[i][k] -= step;
      const double exact = (energy(down, walls, 0.5) - energy(up, walls, 0.5)) / (2 * step);
      CHECK(mass * particles.acceleration.at(i)[k] == Approx(exact).margin(1e-4 * largest));
    }
  if (angle == 180.f) {  // walls are as air
    CHECK(glm::length(momentum) < 1e-5 * largest);
    CHECK(glm::length(turning) < 1e-5 * largest);
  }
}

}  // namespace sim_tension_tests
