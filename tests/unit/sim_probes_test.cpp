// Probes on particles placed by hand, of which all is known.
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "sim/run/probes.hpp"
#include "sim/start/initial.hpp"

namespace sim_probes_tests {

using namespace spindrift::sim;
using glm::vec3;

namespace {

constexpr float spacing = 0.1f;
const DomainSettings domain{{0, 0, 0}, {4, 3, 1}};

/// A block of liquid on a lattice, with hydrostatic pressures under its top.
Frame block(vec3 min, vec3 max) {
  Settings s;
  s.fluid.spacing = spacing;
  s.fluid.volumes = {{Box{min, max}}};
  s.domain = domain;
  Frame frame;
  frame.positions = fill_volumes(s).positions;
  for (const vec3& p : frame.positions)
    frame.pressures.push_back(9810.f * (max.y - p.y));
  frame.velocities.assign(frame.positions.size(), vec3(0));
  return frame;
}

void add_drop(Frame& frame, vec3 position) {
  frame.positions.push_back(position);
  frame.velocities.emplace_back(0);
  frame.pressures.push_back(0);
}

/// Moves every particle at random by up to a part of a spacing along each axis.
Frame shaken(Frame frame, float part) {
  std::mt19937 random(7);
  for (vec3& p : frame.positions)
    for (int axis = 0; axis < 3; ++axis)
      p[axis] += part * spacing * (2.f * static_cast<float>(random()) / 4294967296.f - 1.f);
  return frame;
}

}  // namespace

TEST_CASE("the surface of a block is where its top is, inside, at walls and in corners") {
  const float height = GENERATE(0.1f, 0.2f, 0.7f, 1.5f);
  const Frame frame = block({0, 0, 0}, {2, height, 1});
  for (const float x : {0.f, 0.03f, 0.1f, 0.95f, 1.f})
    for (const float z : {0.f, 0.05f, 0.5f, 1.f})
      CHECK(surface_height(frame, spacing, domain, x, z) ==
            Approx(height).margin(0.12 * double{spacing}));
}

TEST_CASE("the surface of a disordered block is found better than by its highest particle") {
  const Frame frame = shaken(block({0, 0, 0}, {2, 1, 1}), 0.3f);
  double squared = 0, squared_of_highest = 0;
  int count = 0;
  for (float x = 0.3f; x < 1.7f; x += 0.03f, ++count) {
    float highest = 0;
    for (const vec3& p : frame.positions)
      if (std::hypot(p.x - x, p.z - 0.5f) < spacing)
        highest = std::max(highest, p.y + 0.5f * spacing);
    squared += std::pow(surface_height(frame, spacing, domain, x, 0.5f) - 1, 2);
    squared_of_highest += std::pow(double{highest} - 1, 2);
  }
  CHECK(std::sqrt(squared / count) < 0.2 * double{spacing});
  CHECK(squared < 0.6 * squared_of_highest);
}

TEST_CASE("drops over a surface are not the surface, and a second layer of liquid is") {
  Frame frame = block({0, 0, 0}, {2, 0.5f, 1});
  const double before = surface_height(frame, spacing, domain, 1, 0.5f);
  add_drop(frame, {1, 1.5f, 0.5f});
  add_drop(frame, {1, 2.2f, 0.5f});
  add_drop(frame, {1, 2.3f, 0.5f});
  CHECK(surface_height(frame, spacing, domain, 1, 0.5f) == Approx(before).margin(1e-4));
  const Frame arch = block({0.6f, 1.2f, 0}, {1.4f, 1.6f, 1});
  frame.positions.insert(frame.positions.end(), arch.positions.begin(), arch.positions.end());
  CHECK(surface_height(frame, spacing, domain, 1, 0.5f) == Approx(1.6).margin(0.02));
}

TEST_CASE("where no liquid is there is no surface") {
  Frame frame = block({0, 0, 0}, {1, 0.5f, 1});
  CHECK(std::isnan(surface_height(frame, spacing, domain, 2, 0.5f)));
  add_drop(frame, {2, 0.05f, 0.5f});
  CHECK(std::isnan(surface_height(frame, spacing, domain, 2, 0.5f)));
}

TEST_CASE("pressure within the liquid is exact where it is linear, and air has none") {
  const Frame frame = block({0, 0, 0}, {2, 1, 1});
  for (const float y : {0.2f, 0.35f, 0.5f, 0.75f})
    CHECK(pressure_at(frame, spacing, {1, y, 0.5f}) == Approx(9810 * (1 - y)).epsilon(2e-3));
  CHECK(pressure_at(frame, spacing, {1, 1.25f, 0.5f}) == 0);
  CHECK(pressure_at(frame, spacing, {3, 0.1f, 0.5f}) == 0);
}

TEST_CASE("pressure on a wall is that of the liquid half a spacing off it") {
  const Frame frame = block({0, 0, 0}, {2, 1, 1});
  for (const float x : {1.f, 1.02f, 1.05f})
    CHECK(pressure_at(frame, spacing, {x, 0, 0.5f}) ==
          Approx(9810 * (1 - 0.525 * double{spacing})).epsilon(1e-3));
  CHECK(pressure_at(frame, spacing, {2, 0.5f, 0.5f}) == Approx(9810 * 0.5).epsilon(2e-3));
}

TEST_CASE("probes do not see through a wall, fixed or moved, of any thickness") {
  const float thickness = GENERATE(0.005f, 0.5f, 1.5f) * spacing;
  const bool moves = GENERATE(false, true);
  CAPTURE(thickness / spacing, moves);
  Settings s;
  s.fluid.spacing = spacing;
  s.domain = domain;
  // Deep on the left of the wall, shallow on its right.
  Frame frame = block({0, 0, 0}, {2, 1, 1});
  const Frame right = block({2.2f, 0, 0}, {4, 0.3f, 1});
  frame.positions.insert(frame.positions.end(), right.positions.begin(), right.positions.end());
  frame.pressures.insert(frame.pressures.end(), right.pressures.size(), 70.f);
  frame.velocities.resize(frame.positions.size());
  const float shift = moves ? 1 : 0;
  const float far = 2 + thickness;
  s.obstacles = {{.shape = Box{{2 - shift, -1, -1}, {far - shift, 5, 2}}}};
  if (moves) {
    s.obstacles[0].motion.emplace();
    s.obstacles[0].motion->keyframes = {{.time = 0, .translate = {1, 0, 0}, .rotate = {}}};
  }
  const auto pressure = [&](float x, float y) {
    return measure({"p", PressureProbe{{x, y, 0.5f}}}, frame, s)[0];
  };
  const auto height = [&](float x) {
    return measure({"h", SurfaceHeightProbe{x, 0.5f}}, frame, s)[0];
  };
  CHECK(pressure(2, 0.5f) == Approx(9810 * 0.5).epsilon(2e-3));
  CHECK(pressure(1.97f, 0.5f) == Approx(9810 * 0.5).epsilon(2e-3));
  CHECK(pressure(far, 0.7f) == 0);
  CHECK(pressure(far + 0.05f, 0.7f) == 0);
  CHECK(pressure(2.2f, 0.15f) == Approx(70));
  if (thickness < spacing)
    CHECK(pressure_at(frame, spacing, {far, 0.7f, 0.5f}) > 0);  // but for the wall
  CHECK(height(2.2f) < 0.35);
}

TEST_CASE("what is still in a nozzle behind a closed face is not in sight") {
  Settings s;
  s.domain = domain;
  s.domain.open = {Direction::plus_y};
  s.fluid.emitters.emplace_back();
  Frame frame;
  frame.positions = {{1, 1, 0.5f}, {-0.1f, 1, 0.5f}, {0, 0, 0}, {1, 3.1f, 0.5f}, {4, 3, 1.01f}};
  frame.ids = {7, 8, 9, 10, 11};
  frame.velocities.resize(5);
  for (auto* values : {&frame.densities, &frame.pressures, &frame.constraint_multipliers})
    *values = {1, 2, 3, 4, 5};
  const Frame seen = in_sight(s, frame);
  CHECK(seen.ids == std::vector<std::uint32_t>{7, 9, 10});
  CHECK(seen.pressures == std::vector<float>{1, 3, 4});
  CHECK(seen.positions.size() == 3);
  CHECK(seen.positions[2] == frame.positions[3]);
}

TEST_CASE("the front is the bulk's end in every direction, whatever flies ahead") {
  Frame frame = block({0.4f, 0.3f, 0.2f}, {1.9f, 0.8f, 0.7f});
  if (GENERATE(false, true)) {
    for (const vec3 p : {vec3(3, 1, 0.5f), vec3(0.1f, 0, 0.5f), vec3(1, 0.1f, 0.5f),
                         vec3(1, 2.5f, 0.5f), vec3(1, 0.5f, 0.05f), vec3(1, 0.5f, 0.95f)})
      add_drop(frame, p);
    for (const vec3 p : {vec3(2.5f, 1, 0.5f), vec3(2.6f, 1, 0.5f), vec3(2.55f, 1.05f, 0.5f),
                         vec3(2.5f, 1, 0.6f), vec3(2.6f, 1, 0.6f)})  // a clump of five
      add_drop(frame, p);
  }
  const double ends[] = {1.9, 0.4, 0.8, 0.3, 0.7, 0.2};
  for (int d = 0; d < 6; ++d)
    CHECK(front_position(frame, spacing, static_cast<Direction>(d)) ==
          Approx(ends[d]).margin(1e-5));
}

TEST_CASE("a layer one particle thick is a front, and drops alone have none") {
  const Frame sheet = block({0, 0, 0}, {1.5f, 0.1f, 1});
  CHECK(front_position(sheet, spacing, Direction::plus_x) == Approx(1.5).margin(1e-5));
  Frame drops;
  for (int i = 0; i < 10; ++i)
    add_drop(drops, {0.3f * static_cast<float>(i), 0, 0});
  CHECK(std::isnan(front_position(drops, spacing, Direction::plus_x)));
  CHECK(std::isnan(front_position(Frame{}, spacing, Direction::plus_x)));
}

TEST_CASE("energy and volume are those of the block") {
  Frame frame = block({0, 0, 0}, {1, 0.5f, 1});
  for (vec3& v : frame.velocities)
    v = {3, 0, -4};
  Settings s;
  s.fluid.spacing = spacing;
  s.domain = {{-1, -2, 0}, {4, 3, 1}};
  const double mass = 1000 * 0.5;  // kg
  Energy e = energy_of(frame, s);
  CHECK(e.kinetic == Approx(0.5 * mass * 25).epsilon(0.01));
  CHECK(e.potential == Approx(mass * 9.81 * 2.25).epsilon(0.01));
  s.forces.gravity = {9.81f, 0, 0};
  e = energy_of(frame, s);
  CHECK(e.potential == Approx(mass * 9.81 * 3.5).epsilon(0.01));
  const Extent extent = extent_of(frame, spacing);
  CHECK(extent.volume == Approx(0.5).epsilon(0.01));
  CHECK(glm::distance(extent.min, glm::dvec3(0)) < 1e-6);
  CHECK(glm::distance(extent.max, glm::dvec3(1, 0.5, 1)) < 1e-6);
}

TEST_CASE("a probe has a number for each of its columns, named after it with their units") {
  const Frame frame = block({0, 0, 0}, {1, 0.5f, 1});
  Settings s;
  s.fluid.spacing = spacing;
  s.domain = domain;
  const auto header = [](const Probe& probe) {
    std::string text;
    for (const ProbeColumn& column : probe_columns(probe))
      text += column.name + "(" + std::string(column.unit) + ")";
    return text;
  };
  const Probe gauge{"h", SurfaceHeightProbe{0.5f, 0.5f}}, tap{"p", PressureProbe{{0.5f, 0, 0.5f}}},
      front{"f", FrontProbe{}}, energy{"e", EnergyProbe{}}, volume{"v", VolumeProbe{}};
  CHECK(header(gauge) == "h(m)");
  CHECK(header(tap) == "p(Pa)");
  CHECK(header(front) == "f(m)");
  CHECK(header(energy) == "e_kinetic(J)e_potential(J)e_total(J)");
  CHECK(header(volume) == "v(m3)v_min_x(m)v_min_y(m)v_min_z(m)v_max_x(m)v_max_y(m)v_max_z(m)");
  for (const Probe& probe : {gauge, tap, front, energy, volume})
    CHECK(measure(probe, frame, s).size() == probe_columns(probe).size());
  CHECK(measure(front, frame, s)[0] == Approx(1));
  const auto e = measure(energy, frame, s);
  CHECK(e[2] == e[0] + e[1]);
}

}  // namespace sim_probes_tests
