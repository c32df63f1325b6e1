// A closed tank that rocks to and fro, near the frequency of its lowest mode and off it: water
// strikes walls and lid for many periods. What is asked is what hard_cases.hpp asks, and that the
// response is resonant.
#include <catch2/catch.hpp>
#include <numbers>

#include "hard_cases.hpp"
#include "sim/boundary/obstacle_motion.hpp"

namespace sloshing_tests {

using namespace spindrift::sim;
using namespace spindrift::test;

namespace {

constexpr float length = 1, depth = 0.3f, inner_height = 0.6f, width = 0.2f;  // m

/// Of the lowest mode, ω² = g (π/L) tanh(πh/L), Hz.
double lowest_frequency() {
  constexpr double k = std::numbers::pi / length;
  return std::sqrt(9.81 * k * std::tanh(k * depth)) / (2 * std::numbers::pi);
}

/// Six plates about a tank half full, that rock about the middle of its floor.
Settings rocked_tank(SolverType solver, float degrees, double frequency) {
  Settings s = small_scene(solver);
  s.domain = {{-0.4f, -0.4f, -0.2f}, {length + 0.4f, inner_height + 0.4f, width + 0.2f}};
  s.fluid.volumes = {{Box{{0, 0, 0}, {length, depth, width}}}};
  Motion rocking;
  rocking.pivot = {0.5f * length, 0, 0.5f * width};
  rocking.oscillations = {{.rotate = {0, 0, degrees}, .frequency = static_cast<float>(frequency)}};
  const glm::vec3 inside(length, inner_height, width), thick(0.15f);
  for (int axis = 0; axis < 3; ++axis) {
    Box low{-thick, inside + thick}, high = low;
    low.max[axis] = 0;
    high.min[axis] = inside[axis];
    s.obstacles.push_back({.shape = low, .motion = rocking});
    s.obstacles.push_back({.shape = high, .motion = rocking});
  }
  return s;
}

/// How far the centre of mass is from the tank's middle, along its floor, m.
double sway(const Frame& frame, const Motion& rocking) {
  const Pose pose = pose_at(rocking, frame.time);
  double sum = 0;
  for (const glm::vec3& p : frame.positions)
    sum += (glm::transpose(pose.rotation) * (glm::dvec3(p) - pose.translation)).x;
  return sum / static_cast<double>(frame.positions.size()) - 0.5 * length;
}

/// Rocks the tank at a multiple of its lowest frequency. Returns the largest sway in each period,
/// m.
std::vector<double> rock(SolverType solver, float degrees, double multiple, int periods) {
  constexpr int looks = 40;  // in a period
  const double frequency = multiple * lowest_frequency();
  const Settings s = rocked_tank(solver, degrees, frequency);
  Settings run = s;
  Simulation simulation(run);
  InvariantsWatch watch(run);
  double start = 0, most_gained = 0, beyond_work = 0;  // J
  std::vector<double> largest(static_cast<std::size_t>(periods), 0.);
  for (int k = 0; k <= looks * periods; ++k) {
    const FrameStatistics f = simulation.advance_to(k / (looks * frequency));
    const Frame frame = simulation.frame();
    watch.look(frame, f);
    const double energy = f.kinetic_energy + f.potential_energy;
    start = k == 0 ? energy : start;
    const double gained = energy - start;
    most_gained = std::max(most_gained, gained);
    beyond_work = std::max(beyond_work, gained - watch.worst().wall_work);
    double& here = largest[static_cast<std::size_t>(std::max(0, k - 1) / looks)];
    here = std::max(here, std::abs(sway(frame, *s.obstacles[0].motion)));
  }
  const Invariants& found = watch.worst();
  CAPTURE(multiple, found.wall_work, found.rejected, start, most_gained);
  check(fmt::format("a tank rocked by {:g}° at {:g} of its resonance, {} periods", degrees,
                    multiple, periods),
        run, found);
  CHECK(found.wall_work > 0);
  CHECK(beyond_work <= 0.1 * most_gained);
  return largest;
}

}  // namespace

TEST_CASE("hard: a closed tank rocked for three periods answers at its lowest frequency",
          "[hard][slow]") {
  const auto at = rock(SolverType::pcisph, 2, 1, 3), below = rock(SolverType::pcisph, 2, 0.6, 2);
  CAPTURE(at, below);
  CHECK(at[1] > 1.2 * at[0]);
  CHECK(at[2] > 2 * below[1]);
}

TEST_CASE("hard: a closed tank rocked for twelve periods answers at its lowest frequency",
          "[hard][long]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const auto at = rock(solver, 4, 1, 12), below = rock(solver, 4, 0.6, 12),
             above = rock(solver, 4, 1.6, 12);
  CAPTURE(at, below, above);
  CHECK(at[1] > 1.2 * at[0]);
  CHECK(*std::min_element(at.begin() + 2, at.end()) >
        2 * *std::max_element(below.begin() + 2, below.end()));
  CHECK(*std::min_element(at.begin() + 2, at.end()) >
        2 * *std::max_element(above.begin() + 2, above.end()));
}

}  // namespace sloshing_tests
