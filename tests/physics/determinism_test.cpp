// The same scene gives the same bytes: for any number of threads, and when a run is gone on with.
#include <omp.h>

#include <catch2/catch.hpp>
#include <cstring>

#include "sim/simulation.hpp"

using namespace spindrift::sim;

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

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

void check_same(const Frame& a, const Frame& b) {
  CHECK(same_bytes(a.ids, b.ids));
  CHECK(same_bytes(a.positions, b.positions));
  CHECK(same_bytes(a.velocities, b.velocities));
  CHECK(same_bytes(a.pressures, b.pressures));
  CHECK(same_bytes(a.densities, b.densities));
  CHECK(a.last_time_step == b.last_time_step);
}

}  // namespace

TEST_CASE("particles are the same bytes for one, two and four threads") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const int threads_before = omp_get_max_threads();
  std::vector<Frame> frames;
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    Simulation simulation(splash(solver));
    simulation.advance_to(0.1);
    simulation.advance_to(0.2);
    frames.push_back(simulation.frame());
  }
  omp_set_num_threads(threads_before);
  check_same(frames[0], frames[1]);
  check_same(frames[0], frames[2]);
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
