// Scenes in which particle methods explode, leak or break down. In each: all finite, none outside,
// none lost, no energy made, no more compression than the scene asks for.
#include <catch2/catch.hpp>

#include "hard_cases.hpp"

using namespace spindrift::sim;
using namespace spindrift::test;

TEST_CASE("hard: water that falls ten metres onto a floor", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = small_scene(solver);
  s.domain = {{0, 0, 0}, {1.2f, 10.6f, 1.2f}};
  s.fluid.volumes = {{Box{{0.4f, 10, 0.4f}, {0.8f, 10.4f, 0.8f}}}};
  const Invariants end = watch(s, 1.8, 90);
  check("10 m drop", s, end);
  CHECK(end.last.kinetic_energy + end.last.potential_energy < 0.5 * end.energy_start);
}

TEST_CASE("hard: two jets that meet head on at 20 m/s each", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const Settings s = jets(solver);
  check("jets at 20 m/s", s, watch(s, 0.15, 60));
}

TEST_CASE("hard: a splash with steps allowed to be ten times too long", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = splash(solver);
  s.solver.max_time_step = 0.05f;
  s.solver.cfl = 1;
  check("Δt ten times too large", s, watch(s, 1, 30));
}

TEST_CASE("hard: one lone particle falls, and stays where it lands", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = small_scene(solver);
  s.fluid.volumes = {{Sphere{{0.5f, 0.5f, 0.5f}, 0.4f * d}}};
  const Invariants end = watch(s, 1, 60);
  CHECK(end.end.positions.size() == 1);
  check("one lone particle", s, end);
  CHECK(end.end.positions[0].x == 0.5f);
  CHECK(end.end.positions[0].y < d);
  CHECK(end.last.max_speed < 1e-3 + 9.81 * end.last.max_time_step);
}

TEST_CASE("hard: two particles at the same place", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = small_scene(solver);
  const Volume one{Sphere{{0.5f, 0.5f, 0.5f}, 0.4f * d}};
  s.fluid.volumes = {one, one};
  const Invariants end = watch(s, 0.6, 60);
  CHECK(end.end.positions.size() == 2);
  check("two particles at one place", s, end);
}

TEST_CASE("hard: two particles at the same place inside the liquid", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = splash(solver);
  s.fluid.volumes.push_back({Sphere{glm::vec3(4.5f, 4.5f, 4.5f) * d, 0.4f * d}});
  // They start too dense, and are let apart: that is the scene's doing.
  const Invariants end = watch(s, 0.5, 30);
  check("two particles at one place, inside", s, end,
        {.energy = 0.005, .compression_at_start = true});
}

TEST_CASE("hard: particles exactly on a wall, an edge and a corner", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = small_scene(solver);
  s.fluid.volumes.clear();
  for (const glm::vec3 at : {glm::vec3(0, 0.5f, 0.5f), glm::vec3(0, 0.5f, 0), glm::vec3(1, 0, 0.5f),
                             glm::vec3(0, 0, 0), glm::vec3(1, 1, 1)})
    s.fluid.volumes.push_back({Sphere{at, 0.4f * d}});
  const Invariants end = watch(s, 0.6, 60);
  CHECK(end.end.positions.size() == 5);
  check("lone particles on walls", s, end);
}

TEST_CASE("hard: a block whose first layers lie exactly on three walls", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = small_scene(solver);
  s.fluid.volumes = {{Box{glm::vec3(-0.5f * d), glm::vec3(9.5f * d)}}};
  const Invariants end = watch(s, 1, 30);
  CHECK(end.end.positions.size() == 1000);
  check("a block on walls", s, end, {.energy = 0.01, .compression_at_start = true});
  CHECK(end.max_speed < 6);  // what falling gives it, not an explosion
}

TEST_CASE("hard: two blocks that overlap by 30 %", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const Settings s = overlap(solver);
  const Invariants end = watch(s, 2, 60);
  check("blocks that overlap by 30 %", s, end, {.energy = 0.01, .compression_at_start = true});
  CHECK(end.max_speed < 6);
}

TEST_CASE("hard: a block filled twice", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = small_scene(solver);
  const Volume block{Box{{0.3f, 0, 0.3f}, {0.7f, 0.4f, 0.7f}}};
  s.fluid.volumes = {block, block};
  const Invariants end = watch(s, 1, 30);
  check("a block filled twice", s, end, {.energy = 0.01, .compression_at_start = true});
  CHECK(end.max_speed < 6);
}

TEST_CASE("hard: a sheet one particle thick", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const bool upright = GENERATE(false, true);
  Settings s = small_scene(solver);
  s.fluid.volumes = {upright ? Volume{Box{{0.5f, 0.2f, 0}, {0.5f + d, 1, 1}}}
                             : Volume{Box{{0, 0.5f, 0}, {1, 0.5f + d, 1}}}};
  const Invariants end = watch(s, 1, 60);
  CHECK(end.end.positions.size() == (upright ? 320 : 400));
  check(upright ? "an upright sheet" : "a flat sheet", s, end);
}

TEST_CASE("hard: a column 100 particles tall and 5 wide", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const Settings s = column(solver, 5 * d);
  const Invariants end = watch(s, 0.5, 30);
  CHECK(end.end.positions.size() == 2500);
  check("a column 100 tall, 5 wide, held", s, end);
  CHECK(end.max_speed < 2);
}

TEST_CASE("hard: a column 100 particles tall and 5 wide that stands free", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const Settings s = column(solver, 25 * d);
  check("a column 100 tall, 5 wide, free", s, watch(s, 1, 30));
}
