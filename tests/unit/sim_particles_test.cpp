// The list of the particles' fields, and what is done to all of them.
#include <catch2/catch.hpp>
#include <random>
#include <string>
#include <vector>

#include "sim/boundary/neighbourhood.hpp"
#include "sim/particles/particle_exchange.hpp"

namespace sim_particles_tests {

using namespace spindrift::sim;

namespace {

constexpr std::uint32_t count = 700;

/// A number that a particle has in one field, and no other particle in any.
float value_of(std::uint32_t id, std::size_t field) {
  return static_cast<float>(16 * id + field);
}

void set(ScalarField& field, std::uint32_t i, float value) {
  field[i] = value;
}
void set(VectorField& field, std::uint32_t i, float value) {
  field.view().set(i, {value, value + 0.25f, value + 0.5f});
}
void set(PointField& field, std::uint32_t i, float value) {
  field.view().set(i, {value, value, value});
  field.value(i) = value;
}
void set(IdField&, std::uint32_t, float) {}

bool has(const ScalarField& field, std::uint32_t i, float value) {
  return field[i] == value;
}
bool has(const VectorField& field, std::uint32_t i, float value) {
  return field.at(i) == glm::vec3(value, value + 0.25f, value + 0.5f);
}
bool has(const PointField& field, std::uint32_t i, float value) {
  return field.at(i) == glm::vec3(value) && field.value(i) == value;
}
bool has(const IdField&, std::uint32_t, float) {
  return true;
}

/// Particles with all fields, each with a value of its own.
Particles numbered_particles() {
  Particles particles;
  for (ScalarField* field :
       {&particles.held, &particles.compression, &particles.mean_pressure, &particles.excess})
    field->resize(1);
  particles.resize(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    particles.ids[i] = i;
    std::size_t number = 0;
    particles.for_each_field(
        [&](const auto&, auto& field) { set(field, i, value_of(i, number++)); });
  }
  return particles;
}

/// Checks that each particle has its own values in the fields of some lifetimes.
template <class Wanted>
void check_values(Particles& particles, Wanted wanted) {
  std::size_t number = 0;
  particles.for_each_field([&](const auto& info, auto& field) {
    CAPTURE(std::string(info.name));
    bool all = true;
    for (std::uint32_t i = 0; i < particles.count; ++i)
      all = all && has(field, i, value_of(particles.ids[i], number));
    if (wanted(info.lifetime))
      CHECK(all);
    ++number;
  });
}

}  // namespace

TEST_CASE("every field of the particles is in their list, with a unit and a meaning") {
  std::size_t bytes = 0, fields = 0;
  Particles particles = numbered_particles();
  particles.for_each_field([&](const auto& info, auto& field) {
    bytes += sizeof field;
    ++fields;
    CHECK(!info.unit.empty());
    CHECK(!info.meaning.empty());
  });
  CHECK(fields == std::tuple_size_v<decltype(Particles::fields)>);
  CHECK(bytes + alignof(Particles) == sizeof(Particles));  // and their count
  CHECK(particles.memory_bytes() > std::size_t{count} * 4 * 28);
}

TEST_CASE("values stay with their particles when these are sorted, dropped and joined by others") {
  Particles particles = numbered_particles();
  std::mt19937 random(3);
  std::uniform_real_distribution<float> anywhere(0.05f, 0.95f);
  std::vector<glm::vec3> places;
  for (std::uint32_t i = 0; i < count; ++i) {
    places.emplace_back(anywhere(random), anywhere(random), anywhere(random));
    particles.drifted_position.view().set(i, {places[i].x, places[i].y, places[i].z});
  }
  Settings settings;
  settings.fluid.spacing = 0.1f;
  settings.domain = {{0, 0, 0}, {1, 1, 1}};
  const GridMap map = GridMap::over({-0.5f, -0.5f, -0.5f}, {1.5f, 1.5f, 1.5f}, 0.2f);
  Boundary boundary(settings, map, 0.2f, nullptr);
  Neighbourhood neighbourhood(map, boundary);
  Executor executor;
  neighbourhood.update(executor, particles, 0.2f);
  bool moved = false;
  for (std::uint32_t i = 0; i < count; ++i) {
    moved = moved || particles.ids[i] != i;
    particles.drifted_position.view().set(i, {0, 0, 0});
    set(particles.drifted_position, i, value_of(particles.ids[i], 7));
  }
  CHECK(moved);
  check_values(particles, [](Lifetime l) { return l != Lifetime::scratch; });

  ParticleExchange exchange;
  Array<std::uint32_t> kept;
  for (std::uint32_t i = 0; i < count; i += 3)
    kept.push_back(i);
  exchange.keep(executor, particles, kept);
  CHECK(particles.count == kept.size());
  check_values(particles, [](Lifetime l) { return l == Lifetime::state; });

  const std::uint32_t before = particles.count;
  exchange.append(executor, particles, {{1, 2, 3}, {4, 5, 6}}, {7, 8, 9}, {900, 901});
  REQUIRE(particles.count == before + 2);
  CHECK(particles.ids[before + 1] == 901);
  CHECK(particles.position.at(before) == glm::vec3(1, 2, 3));
  CHECK(particles.velocity.at(before + 1) == glm::vec3(7, 8, 9));
  for (const ScalarField* field :
       {&particles.pressure, &particles.held, &particles.compression, &particles.mean_pressure})
    CHECK((*field)[before] == 0);
}

}  // namespace sim_particles_tests
