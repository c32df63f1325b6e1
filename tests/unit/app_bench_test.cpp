// The benchmark: what it runs, what it calls best, and how it writes results down.
#include <algorithm>
#include <atomic>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <sstream>
#include <system_error>

#include "app/bench/bench_measure.hpp"
#include "app/bench/bench_report.hpp"
#include "app/bench/bench_runs.hpp"
#include "app/bench/bench_table.hpp"
#include "app/system/process.hpp"
#include "page_support.hpp"
#include "sim/run/simulation.hpp"
#include "sim/start/initial.hpp"

namespace app_bench_tests {

using namespace spindrift;
using namespace spindrift::app;

namespace {

const std::filesystem::path bench_scenes = std::filesystem::path(SOURCE_DIR) / "scenes/bench";

struct Bounds {
  std::size_t count = 0;
  glm::vec3 min{1e9f}, max{-1e9f};
};

Bounds particles_of(const Scene& scene) {
  Bounds bounds;
  for (const glm::vec3 p : sim::fill_volumes(scene.simulation).positions) {
    bounds.min = glm::min(bounds.min, p);
    bounds.max = glm::max(bounds.max, p);
    ++bounds.count;
  }
  return bounds;
}

void check_same(glm::vec3 a, glm::vec3 b) {
  for (int axis = 0; axis < 3; ++axis)
    CHECK(a[axis] == Approx(b[axis]).margin(1e-4));
}

/// A finished run of the plane.
BenchRow row(double wall_seconds, double mean, double max, float spacing = 0.1f) {
  BenchRow row;
  row.run.scene = parse_scene("{}", "a, \"b\".json");
  row.run.scene.simulation.fluid.spacing = spacing;
  row.result = {.failure = "",
                .particles = 1000,
                .boundary_particles = 500,
                .simulation_bytes = 600'000,
                .peak_bytes = 30'000'000,
                .simulated_seconds = 2,
                .wall_seconds = wall_seconds,
                .steps = 400,
                .rejected_steps = 3,
                .iterations = 1000,
                .mean_compression = mean,
                .max_compression = max,
                .energy_ratio = 1.01,
                .max_speed = 5};
  return row;
}

BenchPlan small_plan() {
  BenchPlan plan = default_plan(true);
  plan.overrides = {"fluid.spacing=0.06"};
  return plan;
}

}  // namespace

TEST_CASE("S1 is 42,875 particles between their walls, as published") {
  const Scene scene = read_scene(bench_scenes / "s1.json");
  const Bounds particles = particles_of(scene);
  CHECK(particles.count == 42875);
  check_same(particles.min, {-1.7f, 0.3f, -1.7f});
  check_same(particles.max, {1.7f, 3.7f, 1.7f});
  check_same(scene.simulation.domain.min, {-2, 0, -2});
  check_same(scene.simulation.domain.max, {2, 4, 2});
  CHECK(scene.video.duration == Approx(1.8));
  CHECK(scene.simulation.solver.cfl == Approx(0.5));
}

TEST_CASE("S2 is 62,500 particles in the corner of a tank, as published") {
  const Scene scene = read_scene(bench_scenes / "s2.json");
  const Bounds particles = particles_of(scene);
  CHECK(particles.count == 62500);
  check_same(particles.min, {0.01f, 0.01f, -0.24f});
  check_same(particles.max, {0.99f, 0.99f, 0.24f});
  check_same(scene.simulation.domain.min, {0, 0, -0.25f});
  check_same(scene.simulation.domain.max, {3.22f, 1.5f, 0.25f});
  CHECK(scene.video.duration == Approx(1));
  CHECK(scene.simulation.solver.max_time_step == Approx(0.005));
}

TEST_CASE("the plane has every combination once, with a scene's values times the factors") {
  BenchPlan plan = small_plan();
  plan.spacing_factors = {1, 2};
  plan.tolerance_factors = {0.25, 1, 4};
  plan.time_step_factors = {0.5, 1};
  const auto runs = planned_runs(plan);
  REQUIRE(runs.size() == 2 * 2 * 3 * 2);
  const auto count = [&](auto&& condition) {
    return std::count_if(runs.begin(), runs.end(), [&](const BenchRun& run) {
      return condition(run.scene.simulation.fluid.spacing, run.scene.simulation.solver);
    });
  };
  using Solver = sim::SolverSettings;
  CHECK(count([](float spacing, const Solver&) { return spacing == 0.12f; }) == 12);
  CHECK(count([](float, const Solver& s) { return s.type == sim::SolverType::sph; }) == 12);
  CHECK(count([](float, const Solver& s) {
          return s.type == sim::SolverType::pcisph && s.mean_compression == 0.004f &&
                 s.max_compression == 0.1f;
        }) == 4);
  // Compression goes with 1 / speed of sound²: a fourth of it takes twice the speed.
  CHECK(count([](float, const Solver& s) {
          return s.type == sim::SolverType::sph && s.speed_of_sound == 120.f;
        }) == 4);
  CHECK(count([](float, const Solver& s) { return s.cfl == 0.2f && s.max_time_step == 0.0025f; }) ==
        12);
}

TEST_CASE("basic SPH without a speed of sound to vary runs once per spacing and step") {
  BenchPlan plan = small_plan();
  plan.overrides.push_back("solver.speed_of_sound=0");
  plan.spacing_factors = {1};
  plan.tolerance_factors = {0.25, 1, 4};
  plan.time_step_factors = {1};
  plan.solvers = {sim::SolverType::sph};
  CHECK(planned_runs(plan).size() == 1);
}

TEST_CASE("a factor that puts a value out of range is refused before anything runs") {
  BenchPlan plan = small_plan();
  plan.time_step_factors = {1, 3};  // CFL number 1.2
  CHECK_THROWS_WITH(planned_runs(plan), Catch::Contains("solver.cfl: 1.2 is out of range"));
}

TEST_CASE("copies of a scene stand side by side, neighbours mirrored") {
  const Scene one = parse_scene(R"({
    "fluid": {"spacing": 0.1, "volumes": [
      {"box": {"min": [1, 0, 2], "max": [1.4, 0.5, 2.2]}, "velocity": [1, 2, 3]}]},
    "domain": {"min": [1, 0, 2], "max": [3, 1, 4]},
    "obstacles": [{"sphere": {"center": [2.5, 0.3, 2.5], "radius": 0.2}}]
  })",
                                "one.json");
  const Scene four = tiled(one, 4);
  check_same(four.simulation.domain.min, {1, 0, 2});
  check_same(four.simulation.domain.max, {5, 1, 6});
  REQUIRE(four.simulation.fluid.volumes.size() == 4);
  REQUIRE(four.simulation.obstacles.size() == 4);
  CHECK(particles_of(four).count == 4 * particles_of(one).count);
  const sim::Volume& mirrored = four.simulation.fluid.volumes[1];
  check_same(std::get<sim::Box>(mirrored.shape).min, {4.6f, 0, 2});
  check_same(std::get<sim::Box>(mirrored.shape).max, {5, 0.5f, 2.2f});
  check_same(mirrored.velocity, {-1, 2, 3});
  check_same(std::get<sim::Sphere>(four.simulation.obstacles[3].shape).center, {3.5f, 0.3f, 5.5f});
  const Scene same = tiled(one, 1);
  CHECK(to_json(same) == to_json(one));
}

TEST_CASE("scaling runs have about the particles asked for, and go through 1, 2, 4 ... threads") {
  CHECK(thread_counts(1) == std::vector<int>{1});
  CHECK(thread_counts(2) == std::vector<int>{1, 2});
  CHECK(thread_counts(6) == std::vector<int>{1, 2, 4, 6});
  BenchPlan plan = default_plan(true);
  plan.plane = false;
  plan.particle_scaling = plan.thread_scaling = true;
  plan.particle_counts = {10'000, 100'000};
  plan.threads = 2;
  const auto runs = planned_runs(plan);
  REQUIRE(runs.size() == 4);
  CHECK(particles_of(runs[0].scene).count == 8192);
  CHECK(runs[0].repetitions == 10);
  CHECK(double(particles_of(runs[1].scene).count) == Approx(100'000).epsilon(0.05));
  CHECK(runs[2].threads == 1);
  CHECK(runs[3].threads == 2);
}

TEST_CASE("the Pareto front leaves out what another point beats in both") {
  const auto front = [](std::vector<CostAndError> points) { return pareto_front(points); };
  using Front = std::vector<bool>;
  CHECK(front({}).empty());
  CHECK(front({{1, 1}}) == Front{true});
  CHECK(front({{1, 4}, {2, 3}, {3, 3.5}, {4, 1}, {5, 1}}) == Front{true, true, false, true, false});
  CHECK(front({{2, 2}, {1, 1}, {3, 3}}) == Front{false, true, false});
  CHECK(front({{1, 2}, {1, 2}}) == Front{true, true});   // the same twice
  CHECK(front({{1, 2}, {1, 3}}) == Front{true, false});  // as fast, but worse
}

TEST_CASE("every spacing has a front of its own, for both errors; failed runs are on none") {
  std::vector<BenchRow> rows{row(1, 0.01, 0.05), row(2, 0.005, 0.06), row(3, 0.02, 0.02),
                             row(0.1, 0.1, 0.2, 0.2f), row(0.05, 0.001, 0.01)};
  rows[4].result.failure = "no step was small enough";
  mark_fronts(rows);
  const auto mean = [&](int i) { return rows[static_cast<std::size_t>(i)].on_mean_front; };
  const auto max = [&](int i) { return rows[static_cast<std::size_t>(i)].on_max_front; };
  CHECK((mean(0) && mean(1) && !mean(2) && mean(3) && !mean(4)));
  CHECK((max(0) && !max(1) && max(2) && max(3) && !max(4)));
}

TEST_CASE("what is derived from a measurement is per simulated second, particle and step") {
  const Measurement m = row(4, 0, 0).result;
  CHECK(wall_per_simulated_second(m) == Approx(2));
  CHECK(nanoseconds_per_particle_step(m) == Approx(4e9 / (1000. * 400)));
  CHECK(iterations_per_step(m) == Approx(2.5));
  CHECK(bytes_per_particle(m) == Approx(600));
  CHECK(wall_per_simulated_second({}) == 0);
}

TEST_CASE("CSV and JSON have the same columns; what was not measured is empty") {
  std::vector<BenchRow> rows{row(4, 0.001, 0.02), row(4, 0, 0)};
  rows[1].result = Measurement{.failure = "needs about 3 GB, 1 GB are free"};
  const auto json = rows_json(rows);
  std::istringstream csv(csv_text(rows));
  std::string header, first, second, rest;
  std::getline(csv, header);
  std::getline(csv, first);
  std::getline(csv, second);
  CHECK_FALSE(std::getline(csv, rest));
  std::string keys;
  for (const auto& [key, value] : json[0].items())
    keys += (keys.empty() ? "" : ",") + key;
  CHECK(header == keys);
  CHECK(first.find("plane,\"a, \"\"b\"\"\",pcisph,0.1,0.001,0.025,") == 0);
  CHECK(second.find("\"needs about 3 GB, 1 GB are free\"") != std::string::npos);
  CHECK(json[0].at("wall_s_per_simulated_s") == 2);
  CHECK(json[0].at("mean_compression") == 0.001);
  CHECK(json[1].at("wall_s_per_simulated_s").is_null());
  CHECK(json[1].at("mean_compression").is_null());
}

TEST_CASE("a run measures its steps, memory, errors and energy") {
  const Scene scene = parse_scene(R"({
    "fluid": {"spacing": 0.1, "volumes": [{"box": {"min": [0, 0.2, 0], "max": [0.4, 0.6, 0.4]}}]},
    "domain": {"min": [0, 0, 0], "max": [0.8, 1, 0.4]},
    "video": {"frames_per_second": 25, "duration": 0.4}
  })",
                                  "small.json");
  const Measurement m = measure({.scene = scene});
  CHECK(m.failure == "");
  CHECK(m.particles == 4 * 4 * 4);
  CHECK(m.boundary_particles > 100);
  CHECK(m.simulated_seconds == Approx(0.4));
  CHECK(m.steps >= 80);  // of at most 5 ms
  CHECK(m.wall_seconds > 0);
  CHECK(m.simulation_bytes > m.particles * 100);
  CHECK(m.peak_bytes > m.simulation_bytes);
  CHECK(m.max_compression >= m.mean_compression);
  CHECK(m.max_speed > 1);  // it fell 0.2 m
  CHECK(m.energy_ratio == Approx(1).margin(0.05));

  const Measurement late = measure({.scene = scene, .warm_up_frames = 5, .repetitions = 2});
  CHECK(late.simulated_seconds == Approx(2 * 0.2));
  CHECK(late.steps < 2 * m.steps);
  CHECK(late.max_speed <= m.max_speed);

  const Measurement cut = measure({.scene = scene, .limit_seconds = 1e-5});
  CHECK(cut.failure == "not done within 1e-05 s");
  CHECK(cut.simulated_seconds < 0.4);
}

TEST_CASE("a run without an admissible step says so and keeps what was measured") {
  const Scene scene = parse_scene(R"({
    "fluid": {"spacing": 0.1, "volumes": [{"box": {"min": [0, 0.5, 0], "max": [0.4, 1.3, 0.4]},
                                           "velocity": [0, -3, 0]}]},
    "domain": {"min": [0, 0, 0], "max": [0.8, 1.5, 0.4]},
    "solver": {"max_iterations": 1, "min_time_step": 0.004},
    "video": {"duration": 1}
  })",
                                  "stuck.json");
  const Measurement m = measure({.scene = scene});
  CHECK_THAT(m.failure, Catch::StartsWith("no time step down to solver.min_time_step"));
  CHECK(m.steps > 0);
  CHECK(m.simulated_seconds < 1);
}

TEST_CASE("a plot has its fronts as lines") {
  std::vector<BenchRow> rows{row(1, 0.01, 0.05), row(2, 0.005, 0), row(3, 0.02, 0.02)};
  mark_fronts(rows);
  const Plot plot = plane_plot({&rows[0], &rows[1], &rows[2]}, false);
  CHECK((plot.log_x && plot.log_y));
  REQUIRE(plot.curves.size() == 3);
  CHECK(plot.curves[0].points == std::vector<std::pair<double, double>>{{1.5, 2}});
  CHECK(plot.curves[1].filled);
  CHECK(plot.curves[1].title == "pcisph, 0.1 m");
  CHECK(plot.curves[2].points == std::vector<std::pair<double, double>>{{0.5, 1}, {1, 0.5}});
  CHECK(plane_plot({&rows[1]}, true).curves[1].points[0].second > 0);  // a logarithm has no zero
}

TEST_CASE("the report holds its plots and tables, and a scene's name as text") {
  std::vector<BenchRow> rows{row(1, 0.01, 0.05), row(2, 0.005, 0.02), row(3, 0.02, 0.02)};
  rows[0].run.scene.name = rows[1].run.scene.name = "<b>";
  rows[2].run.series = BenchSeries::particles;
  const std::string html = report_html(rows);
  const auto plots = test::plots_in(html);
  REQUIRE(plots.size() == 4);
  CHECK((plots[0]["log_x"] && plots[0]["log_y"]));
  CHECK(plots[0]["curves"][0]["points"] == nlohmann::json{{0.5, 1.}, {1., 0.5}});
  CHECK(plots[2]["y_label"] == "ns per particle and step");
  CHECK(plots[3]["curves"].size() == 2);
  CHECK_THAT(html, Catch::Contains("&lt;b&gt;: speed against error") && !Catch::Contains("<b>") &&
                       Catch::Contains("scaling over particles"));
}

TEST_CASE("a program is run with its input, and ended when asked") {
  const std::atomic<bool> go_on{false}, stop{true};
  const std::string large(300'000, 'x');  // more than a pipe holds
  const auto echoed = run_process({"cat"}, large, go_on);
  CHECK(echoed.exit_code == 0);
  CHECK(echoed.out == large);
  const auto failed = run_process({"sh", "-c", "echo no >&2; exit 7"}, "", go_on);
  CHECK(failed.exit_code == 7);
  CHECK(failed.err == "no\n");
  CHECK(run_process({"sleep", "60"}, "", stop).exit_code == 128 + 9);
  CHECK_THROWS_AS(run_process({"no-such-program"}, "", go_on), std::system_error);
}

}  // namespace app_bench_tests
