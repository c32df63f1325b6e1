// What time steps must keep to: their lengths, their stops, and the error that is asked for.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <cmath>
#include <future>
#include <thread>
#include <vector>

#include "sim/run/simulation.hpp"
#include "sim/start/initial.hpp"
#include "sim/step/time_step.hpp"

namespace sim_step_tests {

using namespace spindrift::sim;

TEST_CASE("a block that falls freely costs the fewest steps there can be, and no correction") {
  Settings s;
  s.fluid.spacing = 0.1f;
  s.domain = {{0, 0, 0}, {2, 4, 2}};
  s.fluid.volumes = {{Box{{0.5f, 2, 0.5f}, {1.5f, 3, 1.5f}}}};
  s.solver.max_time_step = 0.005f;
  Simulation simulation(s);
  for (int k = 1; k <= 10; ++k) {
    const FrameStatistics f = simulation.advance_to(k * 0.02);
    CHECK(f.steps == 4);
    CHECK(f.iterations == 0);
  }
}

TEST_CASE("stops do not hold back the steps between them") {
  Settings s;
  s.fluid.spacing = 0.06f;
  s.domain = {{0, 0, 0}, {1.2f, 0.72f, 0.3f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.48f, 0.6f, 0.3f}}}};
  const double end = 0.4;
  Simulation free(s);
  const int needed = free.advance_to(end).steps;
  const auto stop_at = [&](const std::vector<double>& stops, int most) {
    Simulation simulation(s);
    int steps = 0;
    double worst = 0;
    for (const double time : stops) {
      const FrameStatistics f = simulation.advance_to(time);
      steps += f.steps;
      worst = std::max(worst, f.max_compression);
    }
    CAPTURE(stops.size(), needed);
    CHECK(steps <= most);
    CHECK(worst <= 0.0255);
  };
  for (const int rate : {240, 250, 500, 510, 1000}) {
    std::vector<double> stops;
    for (int k = 1; k <= std::lround(rate * end); ++k)
      stops.push_back(k * end / static_cast<double>(std::lround(rate * end)));
    stop_at(stops, static_cast<int>(1.1 * std::max(static_cast<int>(stops.size()), needed)));
  }
  // Of two stops close together each costs a step at the most, not all that it takes to grow back.
  std::vector<double> stops;
  for (int k = 1; k <= 24; ++k) {
    stops.push_back(k * end / 24);
    stops.push_back(k * end / 24 + (k < 24 ? 1e-4 : 0));
  }
  stop_at(stops, needed + static_cast<int>(stops.size()));
}

TEST_CASE("steps grow back from one that ended early as if it had not") {
  SolverSettings solver;
  solver.max_time_step = 0.01f;
  FluidConstants constants{};
  constants.support_radius = 0.1f;
  constants.rest_density = 1000;
  TimeStepControl control(solver, constants, 1);
  CHECK(control.next(1, 0, 0, 0) == Approx(0.01));
  control.accepted(0.01);
  CHECK(control.next(0.001, 0, 0, 0) == Approx(0.001));
  control.accepted(0.001);
  CHECK(control.last() == Approx(0.001));
  CHECK(control.next(1, 0, 0, 0) == Approx(0.01));
  // After one that was refused they grow by 1.3 at a time.
  control.accepted(control.refused(0.01));
  CHECK(control.next(0.0065, 0, 0, 0) == Approx(0.0065));
  control.accepted(0.0065);
  CHECK(control.next(0.001, 0, 0, 0) == Approx(0.001));
  control.accepted(0.001);
  CHECK(control.next(0.0099, 0, 0, 0) == Approx(0.0099));
}

TEST_CASE("a run is told to stop while liquid is let apart that has no room", "[slow]") {
  Settings s;
  s.fluid.spacing = 0.05f;
  s.domain = {{0, 0, 0}, {1, 1, 1}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {1, 1, 1}}}, {Box{{0.01f, 0, 0}, {1, 1, 1}}}};
  Simulation simulation(s);
  std::atomic<bool> stop = false;
  const auto later = std::async(std::launch::async, [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
    stop = true;
  });
  CHECK_NOTHROW(simulation.advance_to(0.1, &stop));  // without it there is an error in the end
}

TEST_CASE("liquid that has no room is told by how much and where", "[slow]") {
  Settings s;
  s.fluid.spacing = 0.1f;
  s.domain = {{0, 0, 0}, {0.4f, 0.4f, 0.4f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {0.4f, 0.4f, 0.4f}}}, {Box{{0, 0, 0}, {0.4f, 0.1f, 0.4f}}}};
  Simulation simulation(s);
  CHECK_THROWS_WITH(simulation.advance_to(0.1),
                    Catch::Contains("finds no rest") && Catch::Contains("is compressed by ") &&
                        Catch::Contains("by 0.1 % and 2.5 % it may be"));
}

TEST_CASE("a tighter tolerance gives a smaller measured error") {
  Settings s;
  s.fluid.spacing = 0.06f;
  s.domain = {{0, 0, 0}, {1.2f, 1.2f, 0.6f}};
  s.fluid.volumes = {{Box{{0, 0.3f, 0}, {0.6f, 0.9f, 0.6f}}}};
  const auto measured = [&](float mean, float largest) {
    s.solver.mean_compression = mean;
    s.solver.max_compression = largest;
    Simulation simulation(s);
    FrameStatistics worst;
    for (int k = 1; k <= 15; ++k) {
      const FrameStatistics f = simulation.advance_to(k * 0.03);
      worst.mean_compression = std::max(worst.mean_compression, f.mean_compression);
      worst.max_compression = std::max(worst.max_compression, f.max_compression);
    }
    return worst;
  };
  const FrameStatistics loose = measured(0.003f, 0.05f), tight = measured(0.0002f, 0.01f);
  CHECK(loose.mean_compression <= 0.003 * 1.1);
  CHECK(loose.max_compression <= 0.05 * 1.1);
  CHECK(tight.mean_compression <= 0.0002 * 1.1);
  CHECK(tight.max_compression <= 0.01 * 1.1);
  CHECK(tight.mean_compression < 0.2 * loose.mean_compression);
}

TEST_CASE("a scene without particles is refused") {
  Settings s;
  s.fluid.volumes.clear();
  CHECK_THROWS_AS(Simulation(s), std::invalid_argument);
}

}  // namespace sim_step_tests
