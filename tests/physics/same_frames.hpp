// What "the same bytes" means for particles.
#pragma once

#include <omp.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <vector>

#include "sim/run/simulation.hpp"

namespace spindrift::test {

template <class T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

inline void check_same(const sim::Frame& a, const sim::Frame& b) {
  CHECK(same_bytes(a.ids, b.ids));
  CHECK(same_bytes(a.positions, b.positions));
  CHECK(same_bytes(a.velocities, b.velocities));
  CHECK(same_bytes(a.pressures, b.pressures));
  CHECK(same_bytes(a.constraint_multipliers, b.constraint_multipliers));
  CHECK(same_bytes(a.densities, b.densities));
  CHECK(same_bytes(a.boundary_pressures, b.boundary_pressures));
  CHECK(a.last_time_step == b.last_time_step);
  CHECK(a.allowed_time_step == b.allowed_time_step);
}

/// Runs a scene to each of the times on one, two and four threads; the last frames must be the
/// same.
inline void check_same_for_threads(const sim::Settings& settings,
                                   const std::vector<double>& times) {
  const int threads_before = omp_get_max_threads();
  std::vector<sim::Frame> frames;
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    sim::Simulation simulation(settings);
    for (const double time : times)
      simulation.advance_to(time);
    frames.push_back(simulation.frame());
  }
  omp_set_num_threads(threads_before);
  check_same(frames[0], frames[1]);
  check_same(frames[0], frames[2]);
}

}  // namespace spindrift::test
