// Fluid lattices, wall samples and contacts.
#include <catch2/catch.hpp>
#include <cmath>

#include "plain_densities.hpp"
#include "sample_support.hpp"
#include "sim/boundary/boundary.hpp"
#include "sim/boundary/contact.hpp"
#include "sim/boundary/domain_walls.hpp"
#include "sim/geometry/shape.hpp"
#include "sim/run/simulation.hpp"
#include "sim/start/fill.hpp"

namespace sim_boundary_tests {

using namespace spindrift::sim;
using spindrift::test::positions;

namespace {

Settings block_in_a_box() {
  Settings s;
  s.fluid.spacing = 0.05f;
  s.domain = {{0, 0, 0}, {0.5f, 0.75f, 0.5f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.5f, 0.5f, 0.5f}}}};
  return s;
}

}  // namespace

TEST_CASE("a box holds a whole lattice, its first centre half a spacing inside") {
  const auto points = fill_shape(Box{{1, 2, 3}, {1.3f, 2.2f, 3.1f}}, 0.1f);
  REQUIRE(points.size() == 3 * 2 * 1);
  CHECK(points.front().x == Approx(1.05f));
  CHECK(points.front().y == Approx(2.05f));
  CHECK(points.back().x == Approx(1.25f));
}

TEST_CASE("a ball and a cylinder hold their volume of particles") {
  const float d = 0.05f, cell = d * d * d;
  const auto ball = fill_shape(Sphere{{0, 1, 0}, 0.5f}, d);
  CHECK(static_cast<float>(ball.size()) * cell == Approx(4.18879f * 0.125f).epsilon(0.03));
  for (const auto p : ball)
    CHECK(glm::length(p - glm::vec3(0, 1, 0)) <= 0.5f);
  const auto rod = fill_shape(Cylinder{{0, 0, 0}, {1, 0, 0}, 0.3f}, d);
  CHECK(static_cast<float>(rod.size()) * cell == Approx(3.14159f * 0.09f).epsilon(0.1));
  const auto pill = fill_shape(Capsule{{0, 0, 0}, {1, 0, 0}, 0.3f}, d);
  CHECK(static_cast<float>(pill.size()) * cell == Approx(3.14159f * 0.09f * 1.4f).epsilon(0.03));
}

TEST_CASE("liquid resting against walls, edges and corners has the rest density") {
  Simulation simulation(block_in_a_box());
  const FrameStatistics start = simulation.advance_to(0);
  CHECK(start.max_compression < 1e-5);
  const Frame frame = simulation.frame();
  for (std::size_t i = 0; i < frame.positions.size(); ++i)
    if (frame.positions[i].y < 0.4f)
      CHECK(frame.densities[i] == Approx(1000).epsilon(0.02));
}

TEST_CASE("a flat face adds to the density what a layer of liquid half a spacing behind it would",
          "[slow]") {
  constexpr float d = 0.05f, radius = 2 * d;
  const bool is_body = GENERATE(false, true);
  const float height = GENERATE(0.2f, 0.5f, 1, 1.4f) * d;  // above the face
  const glm::vec2 off = GENERATE(glm::vec2(0, 0), glm::vec2(0.5f, 0.5f), glm::vec2(0.3f, 0.1f)) * d;
  Settings s;
  s.fluid.spacing = d;
  s.fluid.volumes = {{Sphere{{0.5f, 0.8f, 0.5f}, 0.4f * d}}};  // one particle
  s.domain = {{0, 0, 0}, {1, 1, 1}};
  if (is_body)
    s.obstacles = {{Box{{0.1f, 0.1f, 0.1f}, {0.9f, 0.5f, 0.9f}}}};
  Frame start = Simulation(s).frame();
  REQUIRE(start.positions.size() == 1);
  // Over a boundary particle, but for `off`.
  start.positions[0] = {0.525f + off.x, (is_body ? 0.5f : 0) + height, 0.525f + off.y};
  const double volume = 1 / spindrift::test::lattice_sum(double{d}, double{radius});
  double expected = volume * spindrift::test::cubic_spline(0, double{radius});
  for (int i = -3; i <= 3; ++i)
    for (int k = -3; k <= 3; ++k) {
      const glm::dvec3 apart(i * double{d} - off.x, height + 0.5 * d, k * double{d} - off.y);
      expected += volume * spindrift::test::cubic_spline(glm::length(apart), double{radius});
    }
  CAPTURE(is_body, height / d, off.x / d, off.y / d);
  CHECK(Simulation(s, start).frame().densities[0] / 1000 == Approx(expected).margin(1e-5));
}

TEST_CASE("wall samples lie half a spacing outside the domain, one layer deep, evenly") {
  const DomainSettings domain{{0, 0, 0}, {1, 0.5f, 0.3f}};
  const auto samples = sample_walls(domain, 0.1f);
  CHECK(samples.size() == 12 * 7 * 5 - 10 * 5 * 3);
  for (const auto p : samples) {
    const glm::vec3 outside = glm::max(domain.min - p, p - domain.max);
    CHECK(std::max({outside.x, outside.y, outside.z}) == Approx(0.05f).margin(1e-5));
  }
}

TEST_CASE("obstacle samples lie half a spacing below the surface, about one per spacing squared") {
  const Sphere ball{{0.2f, 0.3f, 0.4f}, 0.5f};
  const auto samples = sample_surface(ball, 0.05f);
  for (const glm::vec3 p : positions(samples))
    CHECK(glm::length(p - ball.center) == Approx(0.475f).epsilon(1e-4));
  CHECK(static_cast<double>(samples.size()) ==
        Approx(4 * 3.14159 * 0.475 * 0.475 / 0.0025).epsilon(0.02));
}

TEST_CASE("a capsule's samples lie half a spacing below its surface, evenly") {
  const float d = 0.05f;
  const Capsule capsule{{0.1f, 0.2f, 0.3f}, {1, 0.5f, -0.4f}, 0.2f};
  const auto samples = positions(sample_surface(capsule, d));
  for (const auto p : samples) {
    const glm::vec3 axis = capsule.to - capsule.from;
    const float along = glm::dot(p - capsule.from, axis) / glm::dot(axis, axis);
    const glm::vec3 nearest = capsule.from + glm::clamp(along, 0.f, 1.f) * axis;
    CHECK(glm::length(p - nearest) == Approx(0.175f).epsilon(1e-4));
  }
  // The same layer, sampled five times as finely.
  Capsule thinner = capsule;
  thinner.radius = 0.175f + 0.1f * d;
  const auto s = spindrift::test::spread(samples, positions(sample_surface(thinner, 0.2f * d)));
  CHECK(s.closest > 0.6f * d);
  CHECK(s.loneliest < 1.4f * d);
  CHECK(s.hole < d);
}

TEST_CASE("contact leaves points in the open alone and takes others to the nearest surface") {
  const std::vector<Obstacle> obstacles{{Box{{1, 0, 1}, {2, 1, 2}}},
                                        {Sphere{{4, 1, 1}, 0.5f}},
                                        {Cylinder{{6, 0, 1}, {6, 2, 1}, 0.5f}},
                                        {Capsule{{7, 1, 1}, {7, 2, 1}, 0.5f}}};
  const std::vector<Solid> solids = solids_of(obstacles);
  const ContactView contact{{0, 0, 0}, {8, 4, 3}, {solids.data(), 4}};
  const auto at = [&](float x, float y, float z) {
    const Vec3<float> p = contact.resolve({x, y, z});
    return glm::vec3(p.x, p.y, p.z);
  };
  CHECK(at(0.5f, 2, 0.5f) == glm::vec3(0.5f, 2, 0.5f));
  CHECK(at(-1, 5, 1) == glm::vec3(0, 4, 1));
  CHECK(at(1.5f, 0.9f, 1.5f) == glm::vec3(1.5f, 1, 1.5f));
  CHECK(at(1.1f, 0.5f, 1.5f) == glm::vec3(1, 0.5f, 1.5f));
  CHECK(glm::length(at(4.1f, 1, 1) - glm::vec3(4.5f, 1, 1)) < 1e-6f);
  CHECK(glm::length(at(6, 0.6f, 1.3f) - glm::vec3(6, 0.6f, 1.5f)) < 1e-6f);
  CHECK(glm::length(at(7, 1.6f, 1.3f) - glm::vec3(7, 1.6f, 1.5f)) < 1e-6f);
  CHECK(glm::length(at(7, 2.3f, 1) - glm::vec3(7, 2.5f, 1)) < 1e-6f);
  CHECK(glm::length(at(7, 0.8f, 1.1f) -
                    (glm::vec3(7, 1, 1) + 0.5f * glm::normalize(glm::vec3(0, -2, 1)))) < 1e-6f);
  CHECK(at(7, 2.4f, 1.4f) == glm::vec3(7, 2.4f, 1.4f));
  CHECK(glm::length(at(7, 1.5f, 1) - glm::vec3(7, 1.5f, 1)) == Approx(0.5f));
}

}  // namespace sim_boundary_tests
