// Surface tension against what is known of drops.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "invariants.hpp"
#include "sim/run/simulation.hpp"

namespace surface_tension_tests {

using namespace spindrift::sim;
using namespace spindrift::test;

namespace {

constexpr double tension = 0.072, density = 1000;  // N/m, kg/m³

/// Weightless water in a box of `width`, m, without liquid yet.
Settings weightless(double spacing, double width) {
  Settings s;
  const auto half = static_cast<float>(0.5 * width);
  s.fluid.spacing = static_cast<float>(spacing);
  s.fluid.viscosity = 0.002f;
  s.fluid.surface_tension = static_cast<float>(tension);
  s.fluid.volumes.clear();
  s.forces.gravity = glm::vec3(0);
  s.domain = {{-half, -half, -half}, {half, half, half}};
  return s;
}

Settings drop(double spacing, double radius) {
  Settings s = weightless(spacing, 4 * radius);
  s.fluid.volumes = {{Sphere{{0, 0, 0}, static_cast<float>(radius)}}};
  return s;
}

/// Radius of the ball that the particles' volume makes, m.
double ball_radius(const Frame& frame, const Settings& s) {
  const double volume = static_cast<double>(frame.ids.size()) * std::pow(s.fluid.spacing, 3);
  return std::cbrt(3 * volume / (4 * std::numbers::pi));
}

/// √(ρR³/σ), s.
double capillary_time(double radius) {
  return std::sqrt(density * std::pow(radius, 3) / tension);
}

struct Moments {
  glm::dvec3 center{0};     ///< m
  glm::dvec3 momentum{0};   ///< mean velocity, m/s
  std::array<double, 6> m;  ///< second moments xx, yy, zz, xy, xz, yz about the centre, m²
  double outer_spread = 0;  ///< standard deviation of the outermost particles' radii, m
  double pressure = 0;      ///< mean in the inner half of the ball's radius, Pa

  /// Largest to smallest principal axis of the moments' ellipsoid, by Jacobi rotations.
  double elongation() const {
    double a[3][3] = {{m[0], m[3], m[4]}, {m[3], m[1], m[5]}, {m[4], m[5], m[2]}};
    for (int sweep = 0; sweep < 20; ++sweep)
      for (int p = 0; p < 2; ++p)
        for (int q = p + 1; q < 3; ++q) {
          const double angle = 0.5 * std::atan2(2 * a[p][q], a[q][q] - a[p][p]);
          const double c = std::cos(angle), s = std::sin(angle);
          for (auto& row : a) {
            const double x = row[p], y = row[q];
            row[p] = c * x - s * y;
            row[q] = s * x + c * y;
          }
          for (int k = 0; k < 3; ++k) {
            const double x = a[p][k], y = a[q][k];
            a[p][k] = c * x - s * y;
            a[q][k] = s * x + c * y;
          }
        }
    const auto [low, high] = std::minmax({a[0][0], a[1][1], a[2][2]});
    return std::sqrt(high / low);
  }
  /// Mode 2 along x, relative to the ball's own moment.
  double mode(double radius) const {
    return (m[0] - 0.5 * (m[1] + m[2])) / (0.2 * radius * radius);
  }
};

Moments shape_of(const Frame& frame, const Settings& s) {
  Moments shape{};
  const auto n = static_cast<double>(frame.ids.size());
  for (std::size_t i = 0; i < frame.ids.size(); ++i) {
    shape.center += glm::dvec3(frame.positions[i]) / n;
    shape.momentum += glm::dvec3(frame.velocities[i]) / n;
  }
  const double radius = ball_radius(frame, s);
  constexpr int directions = 100;
  std::vector<double> outer(directions, 0.);
  double inner = 0;
  for (std::size_t i = 0; i < frame.ids.size(); ++i) {
    const glm::dvec3 r = glm::dvec3(frame.positions[i]) - shape.center;
    const std::array<double, 6> moments{r.x * r.x, r.y * r.y, r.z * r.z,
                                        r.x * r.y, r.x * r.z, r.y * r.z};
    for (std::size_t k = 0; k < 6; ++k)
      shape.m[k] += moments[k] / n;
    if (glm::length(r) < 0.5 * radius) {
      shape.pressure += frame.pressures[i];
      inner += 1;
    }
    for (int k = 0; k < directions; ++k) {  // along a spiral over the sphere
      const double z = 1 - 2 * (k + 0.5) / directions, turn = 2.399963 * k;
      const double across = std::sqrt(1 - z * z);
      const glm::dvec3 to(across * std::cos(turn), across * std::sin(turn), z);
      const double height = glm::dot(r, to);
      if (glm::length(r - height * to) < s.fluid.spacing)
        outer[static_cast<std::size_t>(k)] = std::max(outer[static_cast<std::size_t>(k)], height);
    }
  }
  shape.pressure /= std::max(1., inner);
  double mean = 0, square = 0;
  for (const double h : outer) {
    mean += h / directions;
    square += h * h / directions;
  }
  shape.outer_spread = std::sqrt(std::max(0., square - mean * mean));
  return shape;
}

/// Sets a drop that has calmed down swinging in mode 2, 10 % of its radius along x, and returns the
/// period, s, from the second passage through the ball's shape; the pressure meanwhile goes to
/// `pressure`, Pa.
double period_of_drop(Settings s, double& pressure) {
  s.solver.mean_compression = 1e-4f;
  const auto water = s.fluid.viscosity;
  s.fluid.viscosity = 0.02f;
  Simulation calm(s);
  Frame start = calm.frame();
  const double radius = ball_radius(start, s), time = capillary_time(radius);
  calm.advance_to(3 * time);
  start = calm.frame();
  start.time = 0;
  const auto rate = static_cast<float>(0.1 * std::sqrt(8.) / time);
  for (std::size_t i = 0; i < start.ids.size(); ++i) {
    const glm::vec3 p = start.positions[i];
    start.velocities[i] = rate * glm::vec3(p.x, -0.5f * p.y, -0.5f * p.z);
  }
  s.fluid.viscosity = water;
  Simulation simulation(s, start);
  std::vector<double> passages;
  double last = 0, readings = 0;
  const double step = 0.05 * time;
  pressure = 0;
  for (int k = 1; k < 80 && passages.size() < 2; ++k) {
    simulation.advance_to(k * step);
    const Moments shape = shape_of(simulation.frame(), s);
    const double mode = shape.mode(radius);
    if (k > 2 && mode * last < 0)
      passages.push_back((k - mode / (mode - last)) * step);
    last = mode;
    pressure += shape.pressure;
    readings += 1;
  }
  pressure /= readings;
  REQUIRE(passages.size() == 2);
  return passages[1];
}

/// Errors of a drop's period against Lamb's, ω² = 8σ/(ρR³), and of its pressure against 2σ/R.
void swinging_drop(double radius_in_spacings, double spacing, double largest_period_error,
                   double largest_pressure_error) {
  const Settings s = drop(spacing, radius_in_spacings * spacing);
  const double radius = ball_radius(Simulation(s).frame(), s);
  const double exact = 2 * std::numbers::pi / std::sqrt(8.) * capillary_time(radius);
  double pressure = 0;
  const double period = period_of_drop(s, pressure);
  const double period_error = period / exact - 1;
  const double pressure_error = pressure / (2 * tension / radius) - 1;
  record(fmt::format("drop | {:g} | {:.1f} | {:.4g} | {:.4g} | {:+.0f} | {:.4g} | {:.4g} | {:+.0f}",
                     spacing, radius_in_spacings, exact, period, 100 * period_error,
                     2 * tension / radius, pressure, 100 * pressure_error));
  CHECK(std::abs(period_error) < largest_period_error);
  CHECK(std::abs(pressure_error) < largest_pressure_error);
}

/// The angle at which a spherical cap of the particles' volume meets the plane y = 0, degrees, from
/// the height of its centre of mass.
double contact_angle(const Frame& frame, const Settings& s) {
  const double volume = static_cast<double>(frame.ids.size()) * std::pow(s.fluid.spacing, 3);
  const double center = shape_of(frame, s).center.y;
  double low = 0.05, high = std::numbers::pi - 0.05;
  for (int k = 0; k < 50; ++k) {
    const double angle = 0.5 * (low + high), c = std::cos(angle);
    const double radius = std::cbrt(3 * volume / (std::numbers::pi * (2 + c) * (1 - c) * (1 - c)));
    const double h = radius * (1 - c);
    const double of_cap = 3 * std::pow(2 * radius - h, 2) / (4 * (3 * radius - h)) - radius * c;
    (of_cap < center ? low : high) = angle;
  }
  return 180 / std::numbers::pi * low;
}

/// Where a cap of a ball six spacings in radius settles that meets the plate at `start` first.
double settled_angle(float wanted, double start) {
  constexpr float d = 5e-4f;
  Settings s = weightless(d, 40 * double{d});
  s.domain.min.y = 0;
  s.fluid.viscosity = 0.02f;
  s.fluid.contact_angle = wanted;
  const double height = -6 * double{d} * std::cos(std::numbers::pi / 180 * start);
  s.fluid.volumes = {{Sphere{{0, static_cast<float>(height), 0}, 6 * d}}};
  Simulation simulation(s);
  simulation.advance_to(5 * capillary_time(ball_radius(simulation.frame(), s)));
  return contact_angle(simulation.frame(), s);
}

/// From a flatter and from a rounder cap: the line where the plate becomes dry sticks, so that both
/// stop before they are alike, and what is asked for lies between.
void settles_at(double angle) {
  const auto wanted = static_cast<float>(angle);
  const double risen = settled_angle(wanted, angle - 15),
               fallen = settled_angle(wanted, angle + 15);
  record(fmt::format("angle | {:.0f} | {:.0f} | {:.0f}", angle, risen, fallen));
  CHECK(risen < angle + 8);
  CHECK(fallen > angle - 8);
  CHECK(0.5 * (risen + fallen) == Approx(angle).margin(12));
}

}  // namespace

TEST_CASE("a weightless cube of water becomes a ball, makes no energy and does not wander",
          "[slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  constexpr double d = 5e-4;
  Settings s = weightless(d, 30 * d);
  s.solver.type = solver;
  s.fluid.viscosity = 0.01f;
  constexpr auto half = static_cast<float>(5 * d);
  s.fluid.volumes = {{Box{{-half, -half, -half}, {half, half, half}}}};
  Simulation simulation(s);
  const double radius = ball_radius(simulation.frame(), s), time = capillary_time(radius);
  const double surface = 6 * 100 * d * d * tension;  // J
  CHECK(shape_of(simulation.frame(), s).outer_spread > 0.5 * d);
  double largest = 0;
  for (int k = 1; k <= 10; ++k)
    largest = std::max(largest, simulation.advance_to(0.1 * k * time).kinetic_energy);
  CHECK(largest < 0.2 * surface);
  const FrameStatistics later = simulation.advance_to(4 * time);
  CHECK(later.kinetic_energy < 0.003 * surface);
  const Moments shape = shape_of(simulation.frame(), s);
  CHECK(shape.outer_spread < 0.25 * d);
  CHECK(shape.elongation() < 1.1);
  CHECK(glm::length(shape.center) < 1e-3 * radius);
  CHECK(glm::length(shape.momentum) < 1e-5 * radius / time);
  const FrameStatistics end = simulation.advance_to(8 * time);
  CHECK(end.kinetic_energy < later.kinetic_energy);
}

TEST_CASE("validation: a drop swings as Lamb says, and has Laplace's pressure",
          "[validation][slow]") {
  swinging_drop(8, 5e-4, 0.15, 0.25);
}

TEST_CASE("validation: drops of several resolutions and sizes swing as Lamb says",
          "[validation][long]") {
  swinging_drop(6, 5e-4, 0.2, 0.3);
  swinging_drop(8, 0.01, 0.15, 0.25);
  swinging_drop(10, 5e-4, 0.15, 0.25);
  swinging_drop(12, 5e-4, 0.15, 0.25);
}

TEST_CASE("two drops that touch become one", "[slow]") {
  constexpr double d = 5e-4;
  const auto apart = [](float contact) {
    Settings s = weightless(d, 40 * d);
    s.fluid.surface_tension = contact;
    s.fluid.viscosity = 0.005f;
    constexpr auto r = static_cast<float>(5 * d);
    s.fluid.volumes = {{Sphere{{-r, 0, 0}, r}}, {Sphere{{r, 0, 0}, r}}};
    Simulation simulation(s);
    const double time = capillary_time(ball_radius(simulation.frame(), s));
    simulation.advance_to(4 * time);
    return shape_of(simulation.frame(), s).elongation();
  };
  CHECK(apart(0) > 2.3);
  CHECK(apart(static_cast<float>(tension)) < 1.5);
}

TEST_CASE("a drop on a plate meets it at a right angle") {
  settles_at(90);
}

TEST_CASE("a drop on a plate meets it at its contact angle", "[slow]") {
  settles_at(120);
}

TEST_CASE("a drop of two millimetres at a tenth of a millimetre stays whole and calm", "[slow]") {
  Settings s = drop(1e-4, 1e-3);
  s.fluid.viscosity = 0.001f;
  const Invariants found = watch(s, 0.004, 4);
  CHECK(found.finite);
  CHECK(found.compression.largest < 1.05 * s.solver.max_compression);
  CHECK(found.max_speed < 0.5);
  CHECK(found.rejected == 0);
  const Moments shape = shape_of(found.end, s);
  CHECK(shape.elongation() < 1.05);
  CHECK(shape.outer_spread < 5e-5);
}

TEST_CASE("enormous surface tension shortens the steps and does not tear the liquid") {
  Settings s = drop(0.01, 0.05);
  s.fluid.surface_tension = 1e4f;
  const double time = std::sqrt(density * std::pow(0.05, 3) / 1e4);
  const Invariants found = watch(s, 2 * time, 4);
  CHECK(found.finite);
  CHECK(found.last.max_time_step < 0.3 * std::sqrt(density * 1e-6 / 1e4) * 1.001);
  CHECK(shape_of(found.end, s).elongation() < 1.1);
}

TEST_CASE("drops are the same bytes for all threads, and when a run is gone on with") {
  Settings s = drop(5e-4, 2.5e-3);
  s.domain.min.y = -0.0025f;
  const int threads_before = omp_get_max_threads();
  std::vector<Frame> ends;
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    Simulation simulation(s);
    simulation.advance_to(0.004);
    const Frame half = simulation.frame();
    simulation.advance_to(0.008);
    ends.push_back(simulation.frame());
    Simulation resumed(s, half);
    resumed.advance_to(0.008);
    ends.push_back(resumed.frame());
  }
  omp_set_num_threads(threads_before);
  for (const Frame& end : ends) {
    CHECK(end.positions == ends[0].positions);
    CHECK(end.velocities == ends[0].velocities);
    CHECK(end.pressures == ends[0].pressures);
  }
}

}  // namespace surface_tension_tests
