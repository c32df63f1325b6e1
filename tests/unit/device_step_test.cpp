// Whole runs on the device backend against the processor's.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <glm/glm.hpp>
#include <vector>

#include "sim/device/device_engine.hpp"
#include "sim/engine.hpp"
#include "sim/simulation.hpp"

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
  std::vector<glm::vec3> place(a.ids.size());
  for (std::size_t i = 0; i < a.ids.size(); ++i)
    place[a.ids[i]] = a.positions[i];
  float largest = 0;
  for (std::size_t i = 0; i < b.ids.size(); ++i)
    largest = std::max(largest, glm::distance(b.positions[i], place[b.ids[i]]));
  return largest;
}

void check_same_after(const Settings& settings, int steps) {
  const Runs runs = run_both(settings, double{step} * steps);
  CHECK(runs.device_statistics.steps == runs.cpu_statistics.steps);
  CHECK(runs.device_statistics.rejected_steps == runs.cpu_statistics.rejected_steps);
  CHECK(runs.device_statistics.iterations == runs.cpu_statistics.iterations);
  CHECK(largest_distance(runs.cpu, runs.device) < 1e-4f * settings.fluid.spacing);
  CHECK(runs.device_statistics.contacts == runs.cpu_statistics.contacts);
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

TEST_CASE("volumes that overlap are let apart on the device as on the processor") {
  Settings s = splash();
  s.fluid.volumes.push_back({Box{{0.22f, 0.32f, 0.1f}, {0.42f, 0.52f, 0.3f}}});
  const Runs runs = run_both(s, 0);
  CHECK(largest_distance(runs.cpu, runs.device) < 1e-2f * s.fluid.spacing);
  CHECK(runs.device_statistics.max_compression < 1.2 * s.solver.max_compression);
}

TEST_CASE("a hundred steps on the device compress and iterate as on the processor") {
  const Settings s = splash();
  const Runs runs = run_both(s, 100 * double{step});
  const FrameStatistics &a = runs.cpu_statistics, &b = runs.device_statistics;
  CHECK(b.steps == a.steps);
  CHECK(double(b.iterations) == Approx(double(a.iterations)).epsilon(0.05));
  CHECK(b.mean_compression == Approx(a.mean_compression).epsilon(0.1));
  CHECK(b.max_compression == Approx(a.max_compression).margin(0.005));
  CHECK(b.kinetic_energy == Approx(a.kinetic_energy).epsilon(0.01));
  CHECK(b.potential_energy == Approx(a.potential_energy).epsilon(0.01));
}

TEST_CASE("what the device cannot do yet is said, and nothing else") {
  const auto missing = [](auto change) {
    Settings s = splash();
    change(s);
    return missing_on_device(s);
  };
  CHECK(missing([](Settings&) {}).empty());
  CHECK(missing([](Settings& s) { s.obstacles[0].motion.emplace(); }) ==
        "the scene has obstacles that move, which the CUDA backend cannot do yet");
  CHECK(missing([](Settings& s) { s.obstacles[0].shape = TriangleMesh{}; }) ==
        "the scene has obstacles that are meshes, which the CUDA backend cannot do yet");
  CHECK(missing([](Settings& s) { s.fluid.emitters.emplace_back(); }) ==
        "the scene has emitters, which the CUDA backend cannot do yet");
  CHECK(missing([](Settings& s) { s.sinks.emplace_back(); }) ==
        "the scene has sinks or open faces, which the CUDA backend cannot do yet");
}

TEST_CASE("a run on the device that goes on from a frame ends where one in one piece does") {
  const Settings s = splash();
  const auto whole = make_engine(s);
  whole->advance_to(5 * double{step}, nullptr);
  const Frame middle = whole->frame();
  whole->advance_to(10 * double{step}, nullptr);
  const auto rest = make_engine(s, middle);
  rest->advance_to(10 * double{step}, nullptr);
  CHECK(largest_distance(whole->frame(), rest->frame()) == 0);
}
