// The same scene gives the same bytes: for any number of threads, and when a run is gone on with.
#include <catch2/catch.hpp>

#include "same_frames.hpp"
#include "sim/run/simulation.hpp"

namespace determinism_tests {

using namespace spindrift::sim;
using namespace spindrift::test;

namespace {

Settings splash(SolverType solver) {
  Settings s;
  s.solver.type = solver;
  s.fluid.spacing = 0.05f;
  s.domain = {{0, 0, 0}, {1, 1, 0.5f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.4f, 0.7f, 0.5f}}}};
  s.obstacles = {{Box{{0.6f, 0, 0.1f}, {0.7f, 0.2f, 0.3f}}}};
  return s;
}

}  // namespace

TEST_CASE("particles are the same bytes for one, two and four threads") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  check_same_for_threads(splash(solver), {0.1, 0.2});
}

TEST_CASE("a run that starts with overlapping blocks is gone on with to the same bytes") {
  Settings s = splash(SolverType::pcisph);
  s.fluid.volumes.push_back({Box{{0.02f, 0.3f, 0}, {0.42f, 0.9f, 0.5f}}});
  s.solver.max_compression = 0.01f;
  Simulation whole(s);
  const FrameStatistics start = whole.advance_to(0);
  CHECK(start.max_compression <= s.solver.max_compression);
  CHECK(start.kinetic_energy == 0);  // moved apart, without a velocity
  whole.advance_to(0.004);
  const Frame kept = whole.frame();
  const FrameStatistics late = whole.advance_to(0.1);
  CHECK(late.max_speed < 3);
  Simulation resumed(s, kept);
  resumed.advance_to(0.1);
  check_same(whole.frame(), resumed.frame());
}

TEST_CASE("a run gone on with from a kept frame gives the same bytes as one in one piece") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const Settings s = splash(solver);
  Simulation whole(s);
  whole.advance_to(0.15);
  const Frame kept = whole.frame();
  whole.advance_to(0.25);
  Simulation resumed(s, kept);
  resumed.advance_to(0.25);
  check_same(whole.frame(), resumed.frame());
}

TEST_CASE("a frame of another scene is refused") {
  const Settings s = splash(SolverType::pcisph);
  Settings other = s;
  other.fluid.volumes = {{Box{{0, 0, 0}, {0.4f, 0.4f, 0.5f}}}};
  const Frame frame = Simulation(other).frame();
  CHECK_THROWS_AS(Simulation(s, frame), std::invalid_argument);
}

}  // namespace determinism_tests
