// The air's drag on spray, and what it leaves alone.
#include <catch2/catch.hpp>
#include <cmath>
#include <numbers>

#include "sim/run/simulation.hpp"

namespace drag_tests {

using namespace spindrift::sim;

namespace {

/// A drop of water alone in a shaft, held up by a wind of the speed at which it falls.
struct FallingDrop {
  double diameter;  ///< m
  double speed;     ///< of its fall in air, m/s
};

/// Gunn & Kinzer 1949, "The terminal velocity of fall for water droplets in stagnant air".
constexpr FallingDrop measured[] = {{1e-3, 4.03}, {2e-3, 6.49}, {3e-3, 8.06}, {4e-3, 8.83}};

Settings shaft(const FallingDrop& drop) {
  Settings s;
  s.fluid.spacing = static_cast<float>(drop.diameter * std::cbrt(std::numbers::pi / 6));
  s.fluid.surface_tension = 0.0728f;
  const float d = s.fluid.spacing, half = 2.5f * d;
  s.domain = {{-half, -2, -half}, {half, 2, half}};
  s.fluid.volumes = {{Box{glm::vec3(-0.5f * d), glm::vec3(0.5f * d)}}};
  s.forces.air = AirSettings{.velocity = {0, static_cast<float>(drop.speed), 0}};
  return s;
}

/// A cube of water that falls.
Settings falling_cube() {
  Settings s;
  s.fluid.spacing = 0.02f;
  s.domain = {{-0.5f, -3, -0.5f}, {0.5f, 0.5f, 0.5f}};
  s.fluid.volumes = {{Box{glm::vec3(-0.1f), glm::vec3(0.1f)}, {0, -10, 0}}};
  s.forces.gravity = {0, 0, 0};
  return s;
}

double momentum(const Frame& frame) {
  double sum = 0;
  for (const glm::vec3& v : frame.velocities)
    sum += v.y;
  return sum / static_cast<double>(frame.velocities.size());
}

}  // namespace

TEST_CASE("drops fall through air as fast as those that were measured", "[slow]") {
  for (const FallingDrop& drop : measured) {
    Simulation simulation(shaft(drop));
    REQUIRE(simulation.figures().particles == 1);
    simulation.advance_to(1);
    const double fall = drop.speed - double{simulation.frame().velocities[0].y};
    CAPTURE(drop.diameter, fall);
    CHECK(fall == Approx(drop.speed).epsilon(0.15));
  }
}

TEST_CASE("air slows a cube of water down as a bluff body, and no scene that has none") {
  Settings s = falling_cube();
  Simulation free(s);
  free.advance_to(0.1);
  CHECK(momentum(free.frame()) == Approx(-10).epsilon(1e-5));
  s.forces.air = AirSettings{};
  Simulation slowed(s);
  slowed.advance_to(0.1);
  const double lost = 10 + momentum(slowed.frame());  // m/s
  // ½ ρₐ C A v² of a face of 0.2 by 0.2 m, on 8 kg, for 0.1 s.
  const double of_face = 0.5 * 1.2041 * 0.04 * 100 / 8 * 0.1;
  CAPTURE(lost / of_face);
  CHECK(lost > 0.5 * of_face);
  CHECK(lost < 2.5 * of_face);
}

TEST_CASE("spray goes with the wind, and never faster") {
  Settings s;
  s.fluid.spacing = 0.01f;
  s.domain = {{0, 0, 0}, {2, 0.4f, 0.2f}};
  s.fluid.volumes.clear();
  for (int k = 0; k < 12; ++k) {
    const glm::vec3 at(0.05f + 0.1f * static_cast<float>(k % 4),
                       0.05f + 0.1f * static_cast<float>(k / 4), 0.1f);
    s.fluid.volumes.push_back({Box{at, at + 0.01f}});
  }
  s.forces.gravity = {0, 0, 0};
  s.forces.air = AirSettings{.velocity = {3, 0, 0}};
  s.solver.max_time_step = GENERATE(5e-3f, 5e-2f);
  Simulation simulation(s);
  float before = 0;
  for (int k = 1; k <= 5; ++k) {
    simulation.advance_to(0.1 * k);
    for (const glm::vec3& v : simulation.frame().velocities) {
      CHECK(v.x > before);
      CHECK(v.x < 3);
    }
    before = 0.9f * simulation.frame().velocities[0].x;
  }
}

}  // namespace drag_tests
