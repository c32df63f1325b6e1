// Poses of bodies that move on a script, and contact with them.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sim/boundary/contact.hpp"
#include "sim/boundary/moving_bodies.hpp"
#include "sim/boundary/obstacle_motion.hpp"
#include "sim/start/initial.hpp"

namespace sim_motion_tests {

using namespace spindrift::sim;
using glm::dvec3;

namespace {

constexpr double pi = std::numbers::pi;

Motion keyed(std::vector<MotionKey> keys, Interpolation between) {
  Motion motion;
  motion.keyframes = std::move(keys);
  motion.interpolation = between;
  return motion;
}

dvec3 velocity(const Motion& motion, const dvec3& p, double time) {
  const double h = 1e-5;
  return (pose_at(motion, time + h)(p) - pose_at(motion, time - h)(p)) / (2 * h);
}

void check_near(const dvec3& a, const dvec3& b, double margin = 1e-6) {
  CAPTURE(a.x, a.y, a.z, b.x, b.y, b.z);
  CHECK(glm::length(a - b) < margin);
}

/// A plate across x that goes along x at a speed, m/s, in a scene of spacing 0.1 m.
Settings plate(float thickness, float speed) {
  Settings s;
  s.fluid.spacing = 0.1f;
  s.domain = {{0, 0, 0}, {10, 1, 1}};
  s.obstacles = {{.shape = Box{{0, 0, 0}, {thickness, 1, 1}},
                  .motion = keyed({{}, {.time = 1, .translate = {speed, 0, 0}, .rotate = {}}},
                                  Interpolation::linear)}};
  return s;
}

}  // namespace

TEST_CASE("a body passes its keys, rests at the ends and has no jump in its velocity") {
  const Motion motion = keyed({{.time = 1, .translate = {0, 0, 0}, .rotate = {}},
                               {.time = 2, .translate = {1, 0, 0}, .rotate = {0, 90, 0}},
                               {.time = 4, .translate = {2, 0, 0}, .rotate = {0, 180, 0}}},
                              Interpolation::smooth);
  const dvec3 origin(0);
  check_near(pose_at(motion, 0)(origin), {0, 0, 0});
  check_near(pose_at(motion, 2)(origin), {1, 0, 0});
  check_near(pose_at(motion, 9)(origin), {2, 0, 0});
  check_near(pose_at(motion, 2)({1, 0, 0}), {1, 0, -1});
  for (const double end : {1., 4.})
    check_near(velocity(motion, {1, 0, 0}, end), {0, 0, 0}, 1e-3);
  const dvec3 before = velocity(motion, {1, 0, 0}, 2 - 1e-4),
              after = velocity(motion, {1, 0, 0}, 2 + 1e-4);
  CHECK(glm::length(before) > 0.3);
  check_near(before, after, 1e-2);
  double last = 0;
  for (int k = 0; k <= 100; ++k) {
    const double x = pose_at(motion, 0.05 * k)(origin).x;
    CHECK(x >= last);
    last = x;
  }
}

TEST_CASE("linear keys move at a steady speed") {
  const Motion motion = keyed({{.time = 0, .translate = {0, 0, 0}, .rotate = {}},
                               {.time = 2, .translate = {0, 3, 0}, .rotate = {}}},
                              Interpolation::linear);
  for (const double t : {0.01, 1., 1.99})
    check_near(velocity(motion, {1, 1, 1}, t), {0, 1.5, 0});
  check_near(velocity(motion, {1, 1, 1}, 2.5), {0, 0, 0});
}

TEST_CASE("an oscillation is a sine with the amplitude, frequency and phase given") {
  Motion motion;
  motion.pivot = {0, 1, 0};
  motion.oscillations = {
      {.translate = {0.2f, 0, 0}, .rotate = {0, 0, 0}, .frequency = 2, .phase = 0},
      {.translate = {0, 0.1f, 0}, .rotate = {0, 0, 30}, .frequency = 1, .phase = 90}};
  const dvec3 pivot(0, 1, 0);
  for (const double t : {0., 0.1, 0.37, 1.2}) {
    const dvec3 at(0.2 * std::sin(4 * pi * t), 1 + 0.1 * std::cos(2 * pi * t), 0);
    check_near(pose_at(motion, t)(pivot), at);
    const double angle = pi / 6 * std::cos(2 * pi * t);
    check_near(pose_at(motion, t)({1, 1, 0}), at + dvec3(std::cos(angle), std::sin(angle), 0));
  }
  check_near(velocity(motion, pivot, 0), {0.2 * 4 * pi, 0, 0}, 1e-4);
}

TEST_CASE("a spin turns about its axis through the pivot, on top of what else moves it") {
  Motion motion = keyed({{.time = 0, .translate = {0, 0, 0}, .rotate = {}},
                         {.time = 4, .translate = {0, 0, 4}, .rotate = {}}},
                        Interpolation::linear);
  motion.pivot = {1, 0, 0};
  motion.spin = Spin{{0, 0, 2}, 0.25f};
  check_near(pose_at(motion, 1)({2, 0, 0}), {1, 1, 1});
  check_near(pose_at(motion, 2)({2, 0, 5}), {0, 0, 7});
  check_near(velocity(motion, {2, 0, 0}, 1), {-0.5 * pi, 0, 1}, 1e-4);
  const Obstacle obstacle{.shape = Box{{1, -0.1f, 0}, {3, 0.1f, 0.1f}}, .motion = motion};
  CHECK(fastest_speed(obstacle) >= glm::length(velocity(motion, {3, 0, 0}, 1)));
}

TEST_CASE("contact takes a particle that a fast or thin plate passed to the plate's front") {
  for (const float thickness : {0.02f, 0.5f})
    for (const float way : {0.02f, 0.2f, 1.f, 5.f}) {
      const Settings s = plate(thickness, way);
      const auto bodies = posed_bodies(s, 0, 1);
      // The last lies on the floor, which the plate is flush with, and in its edge with a wall.
      for (const glm::vec3 p : {glm::vec3(0.51f, 0.5f, 0.5f), glm::vec3(0.51f, 0.02f, 0.5f),
                                glm::vec3(0.51f, 0, 0.5f), glm::vec3(0.51f, 0, 1)}) {
        const ContactView contact{{0, 0, 0}, {10, 1, 1}, {nullptr, 0, bodies, 0.1f}};
        const Vec3<float> from{p.x, p.y, p.z};
        const Vec3<float> held = contact.resolve(from, from, Since::start);
        CAPTURE(thickness, way, p.y, p.z, held.x, held.y, held.z);
        CHECK(held.x == Approx(std::max(p.x, way + thickness)).margin(2e-4));
        CHECK(held.y == Approx(p.y).margin(1e-3));
        CHECK(held.z == Approx(p.z).margin(1e-3));
        if (held.x > p.x)
          CHECK(contact.obstacles.velocity_behind(held, held - from).x == Approx(way));
      }
    }
}

TEST_CASE("steps are short enough for the walls' speed, at the start of a move too") {
  Settings s = plate(0.5f, 50);
  s.obstacles[0].motion->keyframes = {{.time = 0.1f, .translate = {0, 0, 0}, .rotate = {}},
                                      {.time = 0.2f, .translate = {5, 0, 0}, .rotate = {}}};
  const GridMap map = GridMap::over({0, 0, 0}, {10, 1, 1}, 0.21f);
  Boundary boundary(without_moving(s), map, 0.2f, nullptr);
  Meshes meshes;
  const MovingBodies moving(s, map, boundary, meshes, nullptr);
  CHECK(moving.step_within(0.1, 0, 0.05) == 0.05);
  CHECK(moving.step_within(0.1, 0.15, 0.05) <= 0.1 / 50 * 1.001);
  const double step = moving.step_within(0.1, 0.099, 0.05);
  CHECK(step <= 0.001 + 0.1 / 50);
  CHECK(step > 0.001);
}

TEST_CASE("samples go with their body; of two layers at one place one stays") {
  Settings s = plate(0.5f, 1);  // flush with the wall at the start
  const GridMap map = GridMap::over({-0.1f, -0.1f, -0.1f}, {10.1f, 1.1f, 1.1f}, 0.21f);
  Boundary boundary(without_moving(s), map, 0.2f, nullptr);
  const std::uint32_t walls = boundary.count();
  const auto near_wall = [&] {  // samples in front of x = 0 or on the wall's layer, mid-height
    int count = 0;
    for (std::uint32_t b = 0; b < boundary.count(); ++b) {
      const Vec3<float> p = boundary.positions()[b];
      count += std::abs(p.y - 0.5f) < 0.3f && std::abs(p.z - 0.5f) < 0.3f && p.x < 5;
    }
    return count;
  };
  const int wall = near_wall();
  Meshes meshes;
  MovingBodies moving(s, map, boundary, meshes, nullptr);
  Executor executor;
  moving.place(executor, 0, 0);
  CHECK(moving.sample_count() > walls);
  CHECK(near_wall() > wall);  // the plate's front and back
  moving.place(executor, 0.9, 1);
  bool found = false;
  for (std::uint32_t b = 0; b < boundary.count(); ++b) {
    const Vec3<float> p = boundary.positions()[b];
    if (std::abs(p.x - 1.45f) < 1e-4f && std::abs(p.y - 0.5f) < 0.3f &&
        std::abs(p.z - 0.5f) < 0.3f) {
      found = true;
      CHECK(boundary.velocities()[b].x == Approx(1).epsilon(1e-4));
    }
  }
  CHECK(found);
}

TEST_CASE("liquid is left out where a body that moves starts") {
  Settings s;
  s.fluid.spacing = 0.1f;
  s.domain = {{0, 0, 0}, {1, 1, 1}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {1, 1, 1}}}};
  s.obstacles = {{.shape = Box{{0.3f, 0.3f, 0.3f}, {0.7f, 0.7f, 0.7f}}, .motion = Motion{}}};
  s.obstacles[0].motion->spin = Spin{};
  CHECK(fill_volumes(s).positions.size() == 1000 - 64);
}

}  // namespace sim_motion_tests
