// Whole runs on the device backend against the processor's.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <future>
#include <glm/glm.hpp>
#include <map>
#include <memory>
#include <vector>

#include "sim/boundary/obstacle_motion.hpp"
#include "sim/geometry/mesh/mesh_body.hpp"
#include "sim/run/device_engine.hpp"
#include "sim/run/engine.hpp"
#include "sim/run/simulation.hpp"

namespace device_step_tests {

using namespace spindrift::sim;

namespace {

constexpr float step = 1e-3f;  // s; shorter than all other limits

/// A column that breaks over obstacles of every shape that has a formula, and a drop above it.
Settings splash() {
  Settings s;
  s.fluid.spacing = 0.05f;
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.4f, 0.6f, 0.4f}}},
                     {Sphere{{0.7f, 0.35f, 0.2f}, 0.11f}, glm::vec3(-1, -2, 0)}};
  s.domain = {{0, 0, 0}, {1.2f, 0.8f, 0.4f}};
  s.obstacles = {{Box{{0.45f, 0, 0.1f}, {0.55f, 0.1f, 0.3f}}},
                 {Sphere{{0.9f, 0.1f, 0.2f}, 0.1f}},
                 {Cylinder{{0.75f, 0, 0.1f}, {0.75f, 0.2f, 0.1f}, 0.06f}},
                 {Capsule{{0.6f, 0.1f, 0.35f}, {0.9f, 0.1f, 0.35f}, 0.05f}}};
  s.solver.max_time_step = step;
  return s;
}

/// A cube, as a mesh.
TriangleMesh mesh_cube(const glm::vec3& center, float half_edge, float spacing) {
  TriangleSurface cube;
  for (int k = 0; k < 8; ++k)
    cube.vertices.push_back(center +
                            half_edge * glm::vec3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  TriangleMesh mesh;
  mesh.body = std::make_shared<MeshBody>(cube, spacing);
  return mesh;
}

/// The same column, on a mesh, with a drop that falls on another mesh's corner.
Settings over_a_mesh() {
  Settings s = splash();
  s.obstacles.clear();
  s.obstacles.push_back({.shape = mesh_cube({0.5f, 0.08f, 0.2f}, 0.08f, s.fluid.spacing)});
  s.obstacles.push_back({.shape = mesh_cube({0.6f, 0.15f, 0.3f}, 0.1f, s.fluid.spacing)});
  return s;
}

/// A plate that is pulled to and fro through the column, along the floor, and a mesh that turns.
Settings stirred() {
  Settings s = splash();
  s.fluid.viscosity = 0.5f;
  s.fluid.wall_viscosity = 0.5f;
  Motion swing;
  swing.oscillations = {{.translate = {0.1f, 0, 0}, .rotate = {0, 0, 20}, .frequency = 2}};
  swing.pivot = {0.45f, 0.2f, 0.2f};
  Motion turn;
  turn.pivot = {0.75f, 0.2f, 0.2f};
  turn.spin = Spin{{0, 0, 1}, 1};
  s.obstacles = {{.shape = Box{{0.4f, 0, 0.05f}, {0.5f, 0.4f, 0.35f}}, .motion = swing},
                 {Sphere{{0.95f, 0.1f, 0.2f}, 0.1f}},
                 {.shape = mesh_cube({0.75f, 0.2f, 0.2f}, 0.1f, s.fluid.spacing), .motion = turn}};
  return s;
}

/// Two jets, one out of the floor, a sink below the column and open faces where the drop is.
Settings flow() {
  Settings s = splash();
  s.obstacles.clear();
  s.fluid.volumes[1].shape = Sphere{{1.1f, 0.35f, 0.2f}, 0.11f};
  s.fluid.volumes[1].velocity = {8, 0, 0};
  s.fluid.emitters = {{.opening = Disc{{0.6f, 0.5f, 0.2f}, {1, 0, 0}, 0.1f}, .speed = 4},
                      {.opening = Rectangle{{0.9f, 0, 0.2f}, {0, 1, 0}, {0, 0, 1}, 0.15f, 0.15f},
                       .speed = 3,
                       .to = 0.02f}};
  s.sinks = {{Box{{0.1f, -0.1f, 0.1f}, {0.3f, 0.06f, 0.3f}}}};
  s.domain.open = {Direction::plus_x, Direction::plus_y};
  return s;
}

struct Runs {
  Frame cpu, device;
  FrameStatistics cpu_statistics, device_statistics;
};

Runs run_both(const Settings& settings, double end) {
  Runs runs;
  Simulation cpu(settings);
  runs.cpu_statistics = cpu.advance_to(end);
  runs.cpu = cpu.frame();
  const auto engine = make_engine(settings);
  runs.device_statistics = engine->advance_to(end, nullptr);
  runs.device = engine->frame();
  return runs;
}

/// How far the particle of any number is from itself on the other backend, at most, m.
float largest_distance(const Frame& a, const Frame& b) {
  REQUIRE(a.ids.size() == b.ids.size());
  std::map<std::uint32_t, glm::vec3> place;
  for (std::size_t i = 0; i < a.ids.size(); ++i)
    place[a.ids[i]] = a.positions[i];
  float largest = 0;
  for (std::size_t i = 0; i < b.ids.size(); ++i)
    largest = std::max(largest, glm::distance(b.positions[i], place.at(b.ids[i])));
  return largest;
}

void check_same_exchange(const Exchange& a, const Exchange& b) {
  CHECK(a.entered == b.entered);
  CHECK(a.held_back == b.held_back);
  CHECK(a.drained == b.drained);
  CHECK(a.left == b.left);
  CHECK(a.energy_in == Approx(b.energy_in).epsilon(1e-4));
  CHECK(a.energy_out == Approx(b.energy_out).epsilon(1e-4));
}

void check_same_frame(const Frame& a, const Frame& b) {
  CHECK(a.time == b.time);
  CHECK(a.last_time_step == b.last_time_step);
  CHECK(a.allowed_time_step == b.allowed_time_step);
  CHECK(a.positions == b.positions);
  CHECK(a.velocities == b.velocities);
  CHECK(a.densities == b.densities);
  CHECK(a.pressures == b.pressures);
  CHECK(a.constraint_multipliers == b.constraint_multipliers);
  CHECK(a.ids == b.ids);
  CHECK(a.boundary_pressures == b.boundary_pressures);
}

void check_same_after(const Settings& settings, int steps) {
  const Runs runs = run_both(settings, double{step} * steps);
  CHECK(runs.device_statistics.steps == runs.cpu_statistics.steps);
  CHECK(runs.device_statistics.rejected_steps == runs.cpu_statistics.rejected_steps);
  CHECK(runs.device_statistics.iterations == runs.cpu_statistics.iterations);
  CHECK(largest_distance(runs.cpu, runs.device) < 1e-4f * settings.fluid.spacing);
  CHECK(runs.device_statistics.contacts == runs.cpu_statistics.contacts);
  CHECK(runs.device_statistics.wall_work ==
        Approx(runs.cpu_statistics.wall_work).epsilon(1e-3).margin(1e-9));
  check_same_exchange(runs.device_statistics.exchange, runs.cpu_statistics.exchange);
}

}  // namespace

TEST_CASE("a step on the device is the processor's") {
  check_same_after(splash(), 1);
}

TEST_CASE("ten steps on the device lead where the processor's do") {
  check_same_after(splash(), 10);
}

TEST_CASE("ten steps of basic SPH on the device lead where the processor's do") {
  Settings s = splash();
  s.solver.type = SolverType::sph;
  s.solver.speed_of_sound = 30;
  s.solver.pressure_kernel = PressureKernel::spiky;
  check_same_after(s, 10);
}

TEST_CASE("ten steps with viscosity and tension on the device lead where the processor's do") {
  Settings s = splash();
  s.fluid.surface_tension = 0.5f;
  s.fluid.contact_angle = 120;
  SECTION("explicit viscosity, slippery walls") {
    s.fluid.viscosity = 0.5f;
  }
  SECTION("implicit viscosity, walls that hold the liquid back, one of them more") {
    s.fluid.viscosity = 50;
    s.fluid.wall_viscosity = 20;
    s.obstacles[0].wall_viscosity = 50.f;
  }
  check_same_after(s, 10);
}

TEST_CASE("steps that are too long are refused on the device as on the processor") {
  Settings s = splash();
  s.fluid.volumes[1].velocity = {-10, -20, 0};
  s.solver.cfl = 2;
  s.solver.max_time_step = 20 * step;
  s.obstacles.clear();
  const Runs runs = run_both(s, 20 * double{step});
  CHECK(runs.cpu_statistics.rejected_steps > 2);
  CHECK(runs.device_statistics.rejected_steps == runs.cpu_statistics.rejected_steps);
  CHECK(runs.device_statistics.steps == runs.cpu_statistics.steps);
  CHECK(runs.device_statistics.iterations == runs.cpu_statistics.iterations);
  CHECK(largest_distance(runs.cpu, runs.device) < 1e-3f * s.fluid.spacing);
}

TEST_CASE("steps among bodies that move lead where the processor's do on the device") {
  check_same_after(stirred(), 1);
  check_same_after(stirred(), 10);
}

TEST_CASE("steps over a mesh lead where the processor's do on the device") {
  check_same_after(over_a_mesh(), 1);
  check_same_after(over_a_mesh(), 10);
}

TEST_CASE("what comes and goes on the device does so as on the processor") {
  check_same_after(flow(), 1);
  check_same_after(flow(), 10);
}

TEST_CASE("volumes that overlap are let apart on the device as on the processor") {
  Settings s = splash();
  s.fluid.volumes.push_back({Box{{0.22f, 0.32f, 0.1f}, {0.42f, 0.52f, 0.3f}}});
  const Runs runs = run_both(s, 0);
  CHECK(largest_distance(runs.cpu, runs.device) < 1e-2f * s.fluid.spacing);
  CHECK(runs.device_statistics.max_compression < 1.2 * s.solver.max_compression);
}

TEST_CASE("a hundred steps on the device compress and iterate as on the processor") {
  Settings s;
  SECTION("over obstacles that stand still") {
    s = splash();
  }
  SECTION("among bodies that move") {
    s = stirred();
  }
  SECTION("over a mesh") {
    s = over_a_mesh();
  }
  SECTION("with an emitter, a sink and an open face") {
    s = flow();
  }
  const Runs runs = run_both(s, 100 * double{step});
  const FrameStatistics &a = runs.cpu_statistics, &b = runs.device_statistics;
  CHECK(b.steps == a.steps);
  CHECK(double(b.iterations) == Approx(double(a.iterations)).epsilon(0.05));
  CHECK(b.mean_compression == Approx(a.mean_compression).epsilon(0.15));
  CHECK(b.max_compression == Approx(a.max_compression).margin(0.005));
  CHECK(b.kinetic_energy == Approx(a.kinetic_energy).epsilon(0.01));
  CHECK(b.potential_energy == Approx(a.potential_energy).epsilon(0.01));
  CHECK(b.wall_work == Approx(a.wall_work).epsilon(0.05));
  check_same_exchange(a.exchange, b.exchange);
  // The scenes are about something.
  CHECK((a.wall_work > 0) == any_moves(s.obstacles));
  const bool flows = !s.fluid.emitters.empty();
  CHECK((a.contacts > 0) == !flows);
  CHECK((a.exchange.entered > 0) == flows);
  CHECK((a.exchange.drained > 0) == flows);
  CHECK((a.exchange.left > 0) == flows);
  CHECK((a.exchange.held_back > 0) == flows);
}

TEST_CASE("a frame that is read after further steps holds what was there when it was taken") {
  const auto engine = make_engine(GENERATE(splash(), stirred()));
  engine->advance_to(double{step}, nullptr);
  const Frame at_once = engine->frame();
  std::future<Frame> first = engine->take_frame();
  engine->advance_to(3 * double{step}, nullptr);
  std::future<Frame> second = engine->take_frame();
  engine->advance_to(5 * double{step}, nullptr);
  const Frame end = engine->frame();
  check_same_frame(first.get(), at_once);
  const Frame middle = second.get();
  CHECK(middle.time == 3 * double{step});
  CHECK(largest_distance(middle, at_once) > 1e-3f);
  CHECK(largest_distance(middle, end) > 1e-3f);
}

TEST_CASE("a frame of the device has every number of the processor's that was put there") {
  const Settings s = GENERATE(splash(), stirred());
  Simulation cpu(s);
  cpu.advance_to(3 * double{step});
  Frame given = cpu.frame();
  Frame back = make_engine(s, given)->frame();
  for (std::size_t i = 0; i < given.densities.size(); ++i)  // computed anew
    REQUIRE(back.densities[i] == Approx(given.densities[i]));
  back.densities = given.densities;
  check_same_frame(back, given);
}

TEST_CASE("a run on the device that goes on from a frame ends where one in one piece does") {
  Settings s;
  SECTION("over obstacles that stand still") {
    s = splash();
  }
  SECTION("among bodies that move") {
    s = stirred();
  }
  SECTION("with an emitter, a sink and an open face") {
    s = flow();
  }
  const auto whole = make_engine(s);
  whole->advance_to(5 * double{step}, nullptr);
  const Frame middle = whole->frame();
  whole->advance_to(10 * double{step}, nullptr);
  const auto rest = make_engine(s, middle);
  rest->advance_to(10 * double{step}, nullptr);
  CHECK(largest_distance(whole->frame(), rest->frame()) == 0);
}

TEST_CASE("a particle of a large liquid takes as much of the device's memory as is said") {
  Settings s;
  s.fluid.spacing = 0.02f;
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.8f, 0.6f, 0.6f}}}};
  s.domain = {{0, 0, 0}, {1.2f, 0.8f, 0.6f}};
  s.solver.max_time_step = 0.002f;
  const auto engine = make_device_engine(s);
  engine->advance_to(0.006, nullptr);
  const RunFigures figures = engine->figures();
  const double bytes =
      static_cast<double>(figures.memory_bytes) / static_cast<double>(figures.particles);
  CAPTURE(bytes);
  CHECK(bytes <= device::bytes_per_particle);
  CHECK(bytes > 0.8 * device::bytes_per_particle);
}

}  // namespace device_step_tests
