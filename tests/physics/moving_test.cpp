// Obstacles that move: walls that push, stir and lift, however fast. What is asked of each hard
// case is in hard_cases.hpp, and besides that nothing gets behind a wall.
#include <catch2/catch.hpp>

#include "hard_cases.hpp"
#include "mesh_support.hpp"
#include "same_frames.hpp"
#include "sim/boundary/obstacle_motion.hpp"

namespace moving_tests {

using namespace spindrift::sim;
using namespace spindrift::test;

namespace {

Obstacle moving(const Shape& shape, const Motion& motion) {
  return {.shape = shape, .motion = motion};
}

/// Goes from rest to rest, or at a steady speed.
Motion way(std::vector<MotionKey> keys, Interpolation between = Interpolation::linear) {
  Motion motion;
  motion.keyframes = std::move(keys);
  motion.interpolation = between;
  return motion;
}

Motion turning(const glm::vec3& pivot, const glm::vec3& axis, float turns_per_second) {
  Motion motion;
  motion.pivot = pivot;
  motion.spin = Spin{axis, turns_per_second};
  return motion;
}

Motion swinging(const Oscillation& oscillation) {
  Motion motion;
  motion.oscillations = {oscillation};
  return motion;
}

/// A block of water in a box, and a piston as wide as the box, that runs at it at once and stops
/// before the end.
Settings piston(SolverType solver, float speed) {
  Settings s = small_scene(solver);
  s.domain = {{0, 0, 0}, {2, 1, 0.4f}};
  s.fluid.volumes = {{Box{{0.4f, 0, 0}, {0.9f, 0.4f, 0.4f}}}};
  s.obstacles = {moving(Box{{0, 0, 0}, {0.2f, 1, 0.4f}},
                        way({{.time = 0}, {.time = 1 / speed, .translate = {1, 0, 0}}}))};
  return s;
}

/// How far the particle that is farthest behind a plane of constant x is behind it, m.
double behind(const Frame& frame, float x) {
  double most = 0;
  for (const glm::vec3& p : frame.positions)
    most = std::max(most, double{x} - p.x);
  return most;
}

}  // namespace

TEST_CASE("hard: a piston that strikes a block at 5 and at 20 m/s", "[hard][slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const float speed = GENERATE(5.f, 20.f);
  const Settings s = piston(solver, speed);
  const double time = 1 / double{speed} + 0.15;
  const Invariants end = watch(s, time, 40);
  check(fmt::format("a piston at {:g} m/s", speed), s, end, {.sph_compression = 0.15});
  CAPTURE(end.wall_work, end.steps, end.rejected, end.max_speed);
  CHECK(behind(end.end, 1.2f) < 1e-5);
  const double mass = 1000 * 0.5 * 0.4 * 0.4;
  CHECK(end.wall_work > 0.4 * mass * speed * speed);
}

TEST_CASE("hard: a thin plate and a body of triangles that strike a block at 20 m/s",
          "[hard][slow]") {
  const bool thin = GENERATE(true, false);
  Settings s = piston(SolverType::pcisph, 20);
  if (thin)
    s.obstacles[0].shape = Box{{0.16f, 0, 0}, {0.2f, 1, 0.4f}};
  else
    s.obstacles[0].shape = solid(box_mesh({-0.2f, -0.1f, -0.1f}, {0.2f, 1.1f, 0.5f}), d);
  const Invariants end = watch(s, 0.1, 40);
  CAPTURE(thin, end.wall_work, end.steps, end.rejected, end.max_speed);
  check(thin ? "a thin plate at 20 m/s" : "a body of triangles at 20 m/s", s, end);
  CHECK(behind(end.end, 1.2f) < 0.15 * d);  // a mesh's edges are rounded
}

TEST_CASE("hard: a mixer that spins twice a second", "[hard][slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = small_scene(solver);
  s.fluid.volumes = {{Box{{0, 0, 0}, {1, 0.4f, 1}}}};
  s.obstacles = {moving(Box{{0.1f, 0.05f, 0.45f}, {0.9f, 0.35f, 0.55f}},
                        turning({0.5f, 0, 0.5f}, {0, 1, 0}, 2))};
  const Invariants end = watch(s, 0.6, 30);
  CAPTURE(end.wall_work, end.steps, end.rejected, end.max_speed);
  check("a mixer at 2 turns/s", s, end);
  CHECK(end.wall_work > 0);
}

namespace {

/// A tank of five plates that swings along x, half full of water.
Settings sloshing(SolverType solver, float amplitude) {
  Settings s = small_scene(solver);
  s.domain = {{-0.5f, -0.2f, -0.1f}, {1.5f, 1, 0.5f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {1, 0.3f, 0.4f}}}};
  // ω² = (gπ/L) tanh(πh/L): the lowest mode's.
  const double omega = std::sqrt(9.81 * M_PI * std::tanh(0.3 * M_PI));
  const Motion swing = swinging(
      {.translate = {amplitude, 0, 0}, .frequency = static_cast<float>(omega / (2 * M_PI))});
  s.obstacles = {moving(Box{{-0.15f, -0.15f, -0.15f}, {1.15f, 0, 0.55f}}, swing),
                 moving(Box{{-0.15f, -0.15f, -0.15f}, {0, 0.9f, 0.55f}}, swing),
                 moving(Box{{1, -0.15f, -0.15f}, {1.15f, 0.9f, 0.55f}}, swing),
                 moving(Box{{-0.15f, -0.15f, -0.15f}, {1.15f, 0.9f, 0}}, swing),
                 moving(Box{{-0.15f, -0.15f, 0.4f}, {1.15f, 0.9f, 0.55f}}, swing)};
  return s;
}

}  // namespace

TEST_CASE("hard: a tank that swings at its lowest frequency", "[hard][slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const Settings s = sloshing(solver, 0.04f);
  const Invariants end = watch(s, 1.2, 40);
  CAPTURE(end.wall_work, end.steps, end.rejected, end.max_speed);
  check("a tank at resonance", s, end);
  CHECK(end.wall_work > 0);
}

TEST_CASE("hard: a gate holds the water until it lifts", "[hard][slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = small_scene(solver);
  s.domain = {{0, 0, 0}, {1.6f, 1.4f, 0.3f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.4f, 0.6f, 0.3f}}}};
  s.obstacles = {moving(
      Box{{0.4f, 0, 0}, {0.5f, 0.7f, 0.3f}},
      way({{.time = 0.3f}, {.time = 0.4f, .translate = {0, 0.7f, 0}}}, Interpolation::smooth))};
  Simulation simulation(s);
  InvariantsWatch watch(s);
  for (int k = 0; k <= 15; ++k) {
    const FrameStatistics f = simulation.advance_to(0.02 * k);
    watch.look(simulation.frame(), f);
  }
  double front = 0;
  for (const glm::vec3& p : watch.worst().end.positions)
    front = std::max(front, double{p.x});
  CHECK(front <= 0.4 + 1e-5);
  for (int k = 16; k <= 40; ++k) {
    const FrameStatistics f = simulation.advance_to(0.02 * k);
    watch.look(simulation.frame(), f);
  }
  const Invariants& end = watch.worst();
  CAPTURE(end.wall_work, end.steps, end.rejected, end.max_speed);
  check("a gate that lifts", s, end);
}

TEST_CASE("water that a gate has let go runs as water without a gate does") {
  const auto mean_x = [](bool gate, double time) {
    Settings s = small_scene(SolverType::pcisph);
    s.domain = {{0, 0, 0}, {1.6f, 1.4f, 0.3f}};
    s.fluid.volumes = {{Box{{0, 0, 0}, {0.4f, 0.6f, 0.3f}}}};
    if (gate)
      s.obstacles = {moving(Box{{0.4f, 0, 0}, {0.5f, 0.7f, 0.3f}},
                            way({{.time = 0.1f}, {.time = 0.11f, .translate = {0, 0.7f, 0}}}))};
    Simulation simulation(s);
    simulation.advance_to(time);
    double sum = 0;
    const Frame frame = simulation.frame();
    for (const glm::vec3& p : frame.positions)
      sum += double{p.x} / static_cast<double>(frame.positions.size());
    return sum;
  };
  const double with = mean_x(true, 0.41), without = mean_x(false, 0.3), start = 0.2;
  CAPTURE(with, without);
  CHECK(with - start == Approx(without - start).epsilon(0.08));
}

namespace {

/// A piston, a paddle and a gate at once, on water that sticks to one of them.
Settings all_at_once(SolverType solver) {
  Settings s = small_scene(solver);
  s.domain.max.z = 0.4f;
  s.fluid.volumes = {{Box{{0.1f, 0, 0}, {0.8f, 0.3f, 0.4f}}}};
  s.obstacles = {moving(Box{{-0.1f, -0.1f, -0.1f}, {0.1f, 1.1f, 0.5f}},
                        swinging({.translate = {0.1f, 0, 0}, .rotate = {}, .frequency = 2})),
                 {Sphere{{0.9f, 0, 0.2f}, 0.08f}},
                 moving(Box{{0.4f, 0.1f, 0.18f}, {0.6f, 0.2f, 0.22f}},
                        turning({0.5f, 0.15f, 0.2f}, {0, 0, 1}, 3))};
  s.fluid.viscosity = 1;
  s.obstacles[2].wall_viscosity = 1.f;
  return s;
}

}  // namespace

TEST_CASE("moving walls give the same bytes for one and two and four threads") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  check_same_for_threads(all_at_once(solver), {0.02, 0.04});
}

TEST_CASE("a run with moving walls is gone on with to the same bytes") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const Settings s = all_at_once(solver);
  Simulation whole(s);
  whole.advance_to(0.05);
  whole.advance_to(0.1);
  const Frame kept = whole.frame();
  whole.advance_to(0.15);
  Simulation resumed(s, kept);
  resumed.advance_to(0.15);
  check_same(whole.frame(), resumed.frame());
}

TEST_CASE("a piston's work is the energy that the water gains") {
  // A plug of water in a shaft, without gravity, pushed from rest to 2.25 m/s and let go.
  const auto kernel = GENERATE(PressureKernel::cubic, PressureKernel::spiky);
  Settings s = small_scene(SolverType::pcisph);
  s.solver.pressure_kernel = kernel;
  s.forces.gravity = {0, 0, 0};
  s.domain = {{0, 0, 0}, {1.6f, 0.4f, 0.4f}};
  s.fluid.volumes = {{Box{{0.2f, 0, 0}, {0.6f, 0.4f, 0.4f}}}};
  s.obstacles = {
      moving(Box{{0, 0, 0}, {0.2f, 0.4f, 0.4f}},
             way({{.time = 0}, {.time = 0.4f, .translate = {0.6f, 0, 0}}}, Interpolation::smooth))};
  const Invariants end = watch(s, 0.3, 10);
  const double mass = 1000 * 0.4 * 0.4 * 0.4;
  CAPTURE(end.wall_work, end.last.kinetic_energy, end.energy_made);
  CHECK(end.last.kinetic_energy > 0.5 * mass * 2.25 * 2.25);  // the piston's speed at its fastest
  CHECK(end.wall_work == Approx(end.last.kinetic_energy).epsilon(0.08));
}

TEST_CASE("water that sticks to two plates that move apart has the straight profile of Couette",
          "[slow]") {
  // In a long box, so that nothing has to flow back; y is measured from the middle.
  const float d_fine = 0.01f, speed = 0.1f;
  Settings s = small_scene(SolverType::pcisph);
  s.fluid.spacing = d_fine;
  s.fluid.viscosity = 20;
  s.forces.gravity = {0, 0, 0};
  s.domain = {{-0.15f, -0.07f, 0}, {0.15f, 0.07f, 0.06f}};
  s.fluid.volumes = {{Box{{-0.15f, -0.05f, 0}, {0.15f, 0.05f, 0.06f}}}};
  for (const float side : {-1.f, 1.f}) {
    const float low = side < 0 ? -0.07f : 0.05f;
    const MotionKey end{.time = 1, .translate = {side * speed, 0, 0}, .rotate = {}};
    s.obstacles.push_back({.shape = Box{{-0.2f, low, -0.02f}, {0.2f, low + 0.02f, 0.08f}},
                           .wall_viscosity = 20.f,
                           .motion = way({{}, end})});
  }
  Simulation simulation(s);
  simulation.advance_to(0.25);
  const Frame frame = simulation.frame();
  double error = 0, norm = 0;
  for (std::size_t i = 0; i < frame.positions.size(); ++i) {
    const glm::vec3 p = frame.positions[i];
    if (std::abs(p.x) > 0.03f)
      continue;
    const double exact = double{speed} * p.y / 0.05;
    error += std::pow(frame.velocities[i].x - exact, 2);
    norm += exact * exact;
  }
  CHECK(std::sqrt(error / norm) < 0.06);
}

}  // namespace moving_tests
