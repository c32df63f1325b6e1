// The neighbour search against brute force.
#include <omp.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <random>
#include <vector>

#include "sim/particles/particles.hpp"

namespace sim_neighbours_tests {

using namespace spindrift::sim;

namespace {

using Points = std::vector<Vec3<float>>;

struct Searched {
  Points sorted;                                  ///< in the grid's order
  std::vector<std::vector<std::uint32_t>> lists;  ///< of each sorted point
};

/// Sorts two sets of points and lists, for each of the first, those of the second within the
/// radius.
Searched search(const Points& points, const Points& others, float radius, Points& sorted_others) {
  const GridMap map = GridMap::over({-1, -1, -1}, {1, 1, 1}, radius);
  const auto sorted = [&](const Points& set, CellGrid& grid, PointField& field) {
    PointField unsorted;
    const auto n = static_cast<std::uint32_t>(set.size());
    unsorted.resize(n);
    for (std::uint32_t i = 0; i < n; ++i)
      unsorted.view().set(i, set[i]);
    grid.sort(map, unsorted.view(), n);
    field.resize(n);
    Points result;
    for (std::uint32_t i = 0; i < n; ++i) {
      result.push_back(set[grid.order()[i]]);
      field.view().set(i, result.back());
    }
    field.view().set(n, {sentinel_position, sentinel_position, sentinel_position});
    return result;
  };
  CellGrid grid, other_grid;
  PointField field, other_field;
  Searched result;
  result.sorted = sorted(points, grid, field);
  sorted_others = sorted(others, other_grid, other_field);
  const auto n = static_cast<std::uint32_t>(points.size()),
             m = static_cast<std::uint32_t>(others.size());
  NeighbourLists lists;
  lists.build(map, grid, field.view(), n, other_grid, other_field.view(), m, radius);
  const NeighbourView view = lists.view();
  for (std::uint32_t i = 0; i < n; ++i) {
    std::vector<std::uint32_t> list;
    view.for_each(i, [&](std::uint32_t j) {
      if (j != m)
        list.push_back(j);
    });
    REQUIRE(view.empty(i) == list.empty());
    result.lists.push_back(list);
  }
  return result;
}

void check_against_brute_force(const Points& points, const Points& others, float radius) {
  Points sorted_others;
  const Searched found = search(points, others, radius, sorted_others);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::vector<std::uint32_t> expected;
    for (std::uint32_t j = 0; j < sorted_others.size(); ++j) {
      const auto d = found.sorted[i] - sorted_others[j];
      if (dot(d, d) < radius * radius)
        expected.push_back(j);
    }
    std::vector<std::uint32_t> list = found.lists[i];
    std::sort(list.begin(), list.end());
    INFO("particle " << i << " of " << points.size());
    REQUIRE(list == expected);
  }
}

Points random_points(int n, float spread, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> coordinate(-spread, spread);
  Points points;
  for (int k = 0; k < n; ++k)
    points.push_back({coordinate(random), coordinate(random), coordinate(random)});
  return points;
}

}  // namespace

TEST_CASE("neighbours of a random cloud are those brute force finds") {
  const Points points = random_points(3000, 0.9f, 1);
  check_against_brute_force(points, points, 0.11f);
}

TEST_CASE("neighbours among another set, walls say, are those brute force finds") {
  check_against_brute_force(random_points(1500, 0.8f, 2), random_points(900, 1.0f, 3), 0.2f);
}

TEST_CASE("a crowd in one cell loses no neighbour") {
  const Points points = random_points(700, 0.01f, 4);
  check_against_brute_force(points, points, 0.1f);
}

TEST_CASE("a list may be longer than the pieces of memory that lists are kept in") {
  const Points crowd = random_points(2 << 16, 0.01f, 8);
  check_against_brute_force({{0, 0, 0}, {0.001f, 0, 0}, {0.5f, 0, 0}}, crowd, 0.1f);
}

TEST_CASE("points in far corners and one alone have the right neighbours") {
  Points points = random_points(50, 0.02f, 5);
  for (auto& p : points)
    p.x = -0.98f + 0.5f * p.x;
  points.push_back({0.99f, 0.99f, 0.99f});
  check_against_brute_force(points, points, 0.03f);
  check_against_brute_force({{0, 0, 0}}, {{0, 0, 0}}, 0.05f);
}

TEST_CASE("the order and the lists are the same for one, two and four threads") {
  const Points points = random_points(5000, 0.9f, 6);
  const int threads_before = omp_get_max_threads();
  std::vector<Searched> results;
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    Points ignored;
    results.push_back(search(points, points, 0.1f, ignored));
  }
  omp_set_num_threads(threads_before);
  CHECK(results[0].lists == results[1].lists);
  CHECK(results[0].lists == results[2].lists);
}

TEST_CASE("cells around a cell are those whose keys say so") {
  const GridMap map = GridMap::over({-1, -1, -1}, {1, 1, 1}, 0.2f);
  Points points = random_points(300, 0.9f, 7);
  PointField field;
  const auto n = static_cast<std::uint32_t>(points.size());
  field.resize(n);
  for (std::uint32_t i = 0; i < n; ++i)
    field.view().set(i, points[i]);
  CellGrid grid;
  grid.sort(map, field.view(), n);
  CellNeighbours neighbours;
  neighbours.build(map, grid.view());
  const CellNeighbourView view = neighbours.view();
  const CellGridView cells = grid.view();
  int occupied = 0, empty = 0;
  for (std::uint32_t c = 0; c < grid.cell_count(); ++c)
    for (int slot = 0; slot < CellNeighbourView::slots; ++slot) {
      const std::int64_t dx = slot % 3 - 1, dy = slot / 3 % 3 - 1, dz = slot / 9 - 1;
      const auto key = static_cast<std::uint64_t>(static_cast<std::int64_t>(cells.cell_key(c)) +
                                                  dx + map.nx * (dy + map.ny * dz));
      std::int32_t expected = -1;
      for (std::uint32_t other = 0; other < grid.cell_count(); ++other)
        if (cells.cell_key(other) == key)
          expected = static_cast<std::int32_t>(other);
      ++(expected < 0 ? empty : occupied);
      REQUIRE(view.at(c, slot) == expected);
    }
  CHECK(occupied > 1000);
  CHECK(empty > 1000);
}

TEST_CASE("weights of the cells around a cell are applied as they stand") {
  const GridMap map = GridMap::over({-1, -1, -1}, {1, 1, 1}, 0.2f);
  const Points points = random_points(300, 0.9f, 9);
  PointField field;
  field.resize(300);
  for (std::uint32_t i = 0; i < 300; ++i)
    field.view().set(i, points[i]);
  CellGrid grid;
  grid.sort(map, field.view(), 300);
  CellNeighbours neighbours;
  neighbours.build(map, grid.view());
  const CellNeighbourView view = neighbours.view();
  const std::uint32_t cells = grid.cell_count();
  ScalarField weights, values, image;
  weights.resize(static_cast<std::uint32_t>(CellNeighbourView::place(cells + lane_count, 0)));
  values.resize(cells);
  image.resize(cells);
  std::mt19937 random(10);
  std::uniform_int_distribution<int> number(-9, 9);  // sums are exact, whatever their order
  for (std::uint32_t c = 0; c < cells; ++c) {
    values[c] = static_cast<float>(number(random));
    for (int slot = 0; slot < CellNeighbourView::slots; ++slot)
      if (view.at(c, slot) >= 0)
        weights[static_cast<std::uint32_t>(CellNeighbourView::place(c, slot))] =
            static_cast<float>(number(random));
  }
  const float *w = weights.data(), *u = values.data();
  float* result = image.data();
  Executor executor;
  executor.for_each("apply", cells,
                    [=] SPINDRIFT_HD(std::uint32_t c) { view.apply(c, w, u, result); });
  executor.wait();
  for (std::uint32_t c = 0; c < cells; ++c) {
    float expected = 0;
    for (int slot = 0; slot < CellNeighbourView::slots; ++slot)
      if (const std::int32_t other = view.at(c, slot); other >= 0)
        expected += (slot == CellNeighbourView::self ? 1.f : -1.f) *
                    w[CellNeighbourView::place(c, slot)] * u[other];
    REQUIRE(image[c] == expected);
  }
}

TEST_CASE("a domain with too many cells for a key is refused") {
  CHECK_THROWS_AS(GridMap::over({0, 0, 0}, {1e8f, 1, 1}, 0.1f), std::invalid_argument);
}

}  // namespace sim_neighbours_tests
