// Lattices that fit the volumes they fill, and what bodies leave of them.
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>

#include "sim/boundary/boundary.hpp"
#include "sim/core/kernels.hpp"
#include "sim/geometry/shape.hpp"
#include "sim/geometry/solid.hpp"
#include "sim/run/simulation.hpp"
#include "sim/start/fill.hpp"
#include "sim/start/initial.hpp"

namespace sim_fill_tests {

using namespace spindrift::sim;

namespace {

Settings pool(float spacing) {
  Settings s;
  s.fluid.spacing = spacing;
  s.domain = {{0, 0, 0}, {1, 0.8f, 0.5f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {1, 0.4f, 0.5f}}}};
  return s;
}

double volume_of_liquid(const Settings& s) {
  return static_cast<double>(fill_volumes(s).positions.size()) *
         std::pow(double{particle_spacing(s)}, 3);
}

}  // namespace

TEST_CASE("a lattice meets both faces of a box that its spacing does not divide") {
  const float d = GENERATE(0.03f, 0.04f, 0.05f, 0.06f, 0.07f);
  const Settings s = pool(d);
  glm::vec3 low(1), high(0);
  for (const glm::vec3& p : fill_volumes(s).positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::vec3 step = lattice_in(Box{{0, 0, 0}, {1, 0.4f, 0.5f}}, d).step;
  const glm::vec3 size(1, 0.4f, 0.5f);
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(std::abs(std::log(step[axis] / d)) < 0.13);
    CHECK(low[axis] == Approx(0.5f * step[axis]).epsilon(1e-4));
    CHECK(high[axis] == Approx(size[axis] - 0.5f * step[axis]).epsilon(1e-4));
  }
  CHECK(volume_of_liquid(s) == Approx(0.2).epsilon(1e-4));
  CHECK(particle_spacing(s) == Approx(d).epsilon(0.03));
}

TEST_CASE("where the spacing divides the volumes, particles are as far apart as is asked for") {
  CHECK(particle_spacing(pool(0.025f)) == 0.025f);
  CHECK(particle_spacing(pool(0.1f)) == 0.1f);
  Settings s = pool(0.05f);
  s.fluid.volumes.push_back({Sphere{{0.5f, 0.6f, 0.25f}, 0.11f}});
  CHECK(particle_spacing(s) == 0.05f);
}

TEST_CASE("all volumes of a scene are filled with particles of one size, each nearly to the brim") {
  Settings s = pool(0.03f);
  s.fluid.volumes.push_back({Box{{0.1f, 0.5f, 0.1f}, {0.55f, 0.71f, 0.35f}}});
  s.fluid.volumes.push_back({Sphere{{0.8f, 0.6f, 0.25f}, 0.15f}});
  const InitialParticles filled = fill_volumes(s);
  const double each = std::pow(double{particle_spacing(s)}, 3);
  REQUIRE(filled.volumes.size() == 3);
  for (std::size_t k = 0; k < 3; ++k)
    CHECK(static_cast<double>(filled.volumes[k].placed) * each ==
          Approx(volume_of(s.fluid.volumes[k].shape)).epsilon(0.04));
}

TEST_CASE("round shapes hold the volume that is asked for") {
  const float d = 0.05f;
  const Shape shape =
      GENERATE(Shape(Sphere{{0, 0, 0}, 0.21f}), Shape(Sphere{{0, 0, 0}, 0.245f}),
               Shape(Sphere{{0, 0, 0}, 0.3f}), Shape(Cylinder{{0, 0, 0}, {0, 0.52f, 0}, 0.23f}),
               Shape(Cylinder{{0, 0, 0}, {0.5f, 0, 0}, 0.3f}),
               Shape(Capsule{{0, 0, 0}, {0.3f, 0.2f, 0}, 0.22f}),
               Shape(Cone{{0, 0, 0}, {0, 0.52f, 0}, 0.4f}),
               Shape(Cone{{0, 0, 0}, {0.3f, 0.3f, 0}, 0.2f, 0.4f}));
  Settings s;
  s.fluid.spacing = d;
  s.domain = {{-1, -1, -1}, {1, 1, 1}};
  s.fluid.volumes = {{shape}};
  CHECK(volume_of_liquid(s) == Approx(volume_of(shape)).epsilon(0.03));
}

TEST_CASE("as many particles are left out as a body takes the place of, fixed or moving") {
  Settings s = pool(0.025f);
  s.fluid.volumes = {{Box{{0, 0, 0}, {1, 0.5f, 0.5f}}}};
  s.obstacles = {{Sphere{{0.5f, 0.25f, 0.25f}, 0.12f}}};
  if (GENERATE(false, true))
    s.obstacles[0].motion.emplace().oscillations = {{{0, 0.1f, 0}, {0, 0, 0}, 1, 0}};
  const InitialParticles filled = fill_volumes(s);
  const double taken = 4. / 3 * 3.14159265 * std::pow(0.12, 3) / std::pow(0.025, 3);
  CHECK(static_cast<double>(filled.volumes[0].in_obstacles.at(0)) == Approx(taken).epsilon(0.03));
  CHECK(filled.volumes[0].placed + filled.volumes[0].in_obstacles.at(0) == 16000);
  for (const glm::vec3& p : filled.positions)
    CHECK(glm::distance(p, glm::vec3(0.5f, 0.25f, 0.25f)) > 0.1199f);
}

TEST_CASE("a body between two layers of a lattice leaves the others as they were") {
  Settings s = pool(0.05f);
  s.obstacles = {{Box{{0.4f, 0, 0.15f}, {0.6f, 0.6f, 0.35f}}}};
  const InitialParticles filled = fill_volumes(s);
  CHECK(filled.positions.size() == 1600 - 4 * 4 * 8);
  for (const glm::vec3& p : filled.positions) {
    const glm::vec3 cells = p / 0.05f - 0.5f;
    CHECK(glm::distance(cells, glm::round(cells)) < 1e-4f);
    CHECK_FALSE(is_inside(s.obstacles[0].shape, p));
  }
}

TEST_CASE("a body far larger than the tank leaves no liquid, one beside it all") {
  Settings s = pool(0.05f);
  s.obstacles = {{Box{glm::vec3(-3e9f), glm::vec3(3e9f)}}};
  CHECK(fill_volumes(s).positions.empty());
  s.obstacles = {{Box{{-3e9f, -3e9f, -3e9f}, {3e9f, 0, 3e9f}}}};
  CHECK(fill_volumes(s).positions.size() == 1600);
}

TEST_CASE("an obstacle outside the domain has no samples") {
  Settings s = pool(0.05f);
  const Simulation without(s);
  s.obstacles = {{Box{{5, 0, 0}, {5.3f, 0.3f, 0.3f}}}};
  CHECK(Simulation(s).figures().boundary_particles == without.figures().boundary_particles);
}

TEST_CASE("a simulation that is no longer wanted ends before it begins") {
  std::atomic<bool> stop = true;
  CHECK_THROWS_AS(Simulation(pool(0.05f), &stop), Stopped);
  Simulation simulation(pool(0.05f));
  CHECK(simulation.advance_to(100, &stop).steps == 0);
}

TEST_CASE("making the samples of walls hears that it is no longer wanted") {
  const Settings s = pool(0.05f);
  const float radius = 2 * s.fluid.spacing;
  const std::atomic<bool> stop = true;
  const GridMap map = GridMap::over({0, 0, 0}, from_glm(s.domain.max), radius);
  CHECK_THROWS_AS(Boundary(s, map, radius, &stop), Stopped);
  const auto samples = sample_surface(Box{glm::vec3(0.1f), glm::vec3(0.4f)}, s.fluid.spacing);
  CHECK_NOTHROW(Boundary(s, samples, map, radius, nullptr));
  CHECK_THROWS_AS(Boundary(s, samples, map, radius, &stop), Stopped);
}

}  // namespace sim_fill_tests
