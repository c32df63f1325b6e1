// Settings in which particle methods explode, leak or break down: forces, viscosities, sizes, and a
// long time. What is asked of each is in hard_cases.hpp.
#include <catch2/catch.hpp>
#include <numbers>

#include "hard_cases.hpp"
#include "same_frames.hpp"

namespace hard_settings_tests {

using namespace spindrift::sim;
using namespace spindrift::test;

namespace {

/// A tank half full, as wide as it is high.
Settings half_full(SolverType solver) {
  Settings s = small_scene(solver);
  s.domain.max.z = 0.25f;
  s.fluid.volumes = {{Box{{0, 0, 0}, {1, 0.5f, 0.25f}}}};
  return s;
}

}  // namespace

TEST_CASE("hard: water through a gap narrower than the support radius", "[hard][slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const float gap = GENERATE(0.5f, 1.f, 1.5f) * d;
  Settings s = small_scene(solver);
  s.domain.max.z = 0.25f;
  s.fluid.volumes = {{Box{{0.3f, 0.5f, 0}, {0.7f, 0.9f, 0.25f}}}};
  s.obstacles = {{Box{{0, 0.3f, -0.1f}, {0.5f - 0.5f * gap, 0.4f, 0.35f}}},
                 {Box{{0.5f + 0.5f * gap, 0.3f, -0.1f}, {1.1f, 0.4f, 0.35f}}}};
  check(fmt::format("a gap of {} spacings", gap / d), s, watch(s, 1, 30));
}

TEST_CASE("hard: a ball of water at rest without gravity stays as it is", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = small_scene(solver);
  s.forces.gravity = glm::vec3(0);
  s.fluid.volumes = {{Sphere{{0.5f, 0.5f, 0.5f}, 0.3f}}};
  s.solver.speed_of_sound = 10;
  const Invariants end = watch(s, 1, 10);
  check("zero gravity, at rest", s, end);
  CHECK(end.max_speed < 1e-3);
}

TEST_CASE("hard: a block thrown into a corner without gravity", "[hard]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = small_scene(solver);
  s.forces.gravity = glm::vec3(0);
  s.fluid.volumes = {{Box{{0.4f, 0.4f, 0.4f}, {0.8f, 0.8f, 0.8f}}, {3, 2, 1}}};
  // Three walls at once: more than the v/c = 0.1 of water that meets one.
  check("zero gravity, thrown", s, watch(s, 1, 30), {.sph_compression = 0.15});
}

TEST_CASE("hard: gravity that turns round within a hundredth of a second", "[hard][slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = half_full(solver);
  const glm::vec3 up(0, 2 * 9.81f, 0);
  s.forces.body = {{0.3f, glm::vec3(0)}, {0.31f, up}, {1.f, up}, {1.01f, glm::vec3(0)}};
  check("gravity that reverses", s, watch(s, 1.8, 540));
}

namespace {

void shake(SolverType solver) {
  Settings s = half_full(solver);
  // ω² = gk tanh(kh), with k = π/L.
  const double k = std::numbers::pi, omega = std::sqrt(9.81 * k * std::tanh(0.5 * k));
  const double duration = 4;
  for (double t = 0; t <= duration; t += 0.02)
    s.forces.body.push_back(
        {static_cast<float>(t), {static_cast<float>(std::sin(omega * t)), 0, 0}});
  const Invariants end = watch(s, duration, 400);
  check("sloshing at resonance", s, end);
  // Off resonance the surface would only lean by a/g: here motion builds up.
  CHECK(end.max_speed > 1);
}

}  // namespace

TEST_CASE("hard: a tank shaken at the resonance of its first mode", "[hard][slow]") {
  shake(SolverType::pcisph);
}

TEST_CASE("hard: a tank shaken at the resonance of its first mode, basic SPH", "[hard][slow]") {
  shake(SolverType::sph);
}

TEST_CASE("hard: viscosity from nothing to syrup", "[hard][slow]") {
  const double viscosity = GENERATE(0., 1e-3, 0.1, 1., 10.);
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  Settings s = splash(solver);
  s.fluid.viscosity = static_cast<float>(viscosity);
  check(fmt::format("viscosity {} Pa·s", viscosity), s, watch(s, 0.6, 30));
}

TEST_CASE("hard: a scene one millimetre and one kilometre in size", "[hard][slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const float size = GENERATE(1e-3f, 1e3f);  // m
  Settings s = splash(solver);
  s.fluid.spacing *= size;
  s.fluid.viscosity = 0;
  s.domain.max *= size;
  s.fluid.volumes = {{Box{{0, 0, 0}, size * glm::vec3(0.4f, 0.6f, 0.4f)}}};
  s.obstacles = {{Box{size * glm::vec3(0.6f, 0, 0.1f), size * glm::vec3(0.7f, 0.15f, 0.3f)}}};
  s.solver.max_time_step *= std::sqrt(size);
  check(size < 1 ? "1 mm in size" : "1 km in size", s, watch(s, std::sqrt(size), 30));
}

TEST_CASE("hard: a millimetre and a kilometre with the default limit of the step", "[hard][slow]") {
  const float size = GENERATE(1e-3f, 1e3f);  // m
  Settings s = splash(SolverType::pcisph);
  s.fluid.spacing *= size;
  s.domain.max *= size;
  s.fluid.volumes = {{Box{{0, 0, 0}, size * glm::vec3(0.4f, 0.6f, 0.4f)}}};
  s.obstacles.clear();
  check(size < 1 ? "1 mm, default step" : "1 km, default step", s,
        watch(s, size < 1 ? 0.03 : 3, 30));
}

namespace {

void rest(SolverType solver, double duration) {
  const Settings s = half_full(solver);
  const Invariants end = watch(s, duration, static_cast<int>(10 * duration));
  check(fmt::format("{} s at rest", duration), s, end);
  CHECK(end.last.kinetic_energy < 1e-3 * end.energy_start);
}

}  // namespace

TEST_CASE("hard: a tank left at rest", "[hard]") {
  rest(SolverType::pcisph, 3);
}

TEST_CASE("hard: a tank left at rest, basic SPH", "[hard][slow]") {
  rest(SolverType::sph, 3);
}

TEST_CASE("hard: a tank left at rest for a minute", "[hard][long]") {
  rest(SolverType::pcisph, 60);
}

TEST_CASE("hard: a tank left at rest for a minute, basic SPH", "[hard][long]") {
  rest(SolverType::sph, 60);
}

TEST_CASE("hard: the same bytes for one, two and four threads", "[hard][slow]") {
  const SolverType solver = GENERATE(SolverType::pcisph, SolverType::sph);
  const Settings s = GENERATE_COPY(jets(solver), overlap(solver), column(solver, 7 * d));
  check_same_for_threads(s, {0.02});
}

}  // namespace hard_settings_tests
