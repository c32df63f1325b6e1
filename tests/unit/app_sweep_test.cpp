// Sweeps: which runs there are, and what the runs are ranked by.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <fstream>
#include <set>

#include "app/run/report.hpp"
#include "app/sweep/sweep_file.hpp"
#include "app/sweep/sweep_folder.hpp"
#include "app/sweep/sweep_plan.hpp"
#include "app/sweep/sweep_results.hpp"
#include "app/tables/values.hpp"
#include "output_support.hpp"

namespace app_sweep_tests {

using namespace spindrift;
using namespace spindrift::app;
using Catch::Matchers::Contains;
using output_test::TemporaryFolder;

namespace {

const std::filesystem::path source = SOURCE_DIR;
const std::filesystem::path small_scene = source / "scenes/small_dam_break.json";

SweepPlan plan_of(std::vector<std::string> sets, const std::string& reference = "") {
  SweepRequest request{.scene = small_scene, .reference = reference};
  for (const std::string& set : sets)
    request.axes.push_back(parse_sweep_axis(set));
  return plan_sweep(request);
}

std::vector<std::string> names_of(const SweepPlan& plan) {
  std::vector<std::string> names;
  for (const SweepRun& run : plan.runs)
    names.push_back(run.name);
  return names;
}

std::optional<SweepRequest> read_text(const TemporaryFolder& folder, const std::string& text) {
  const auto file = folder / "sweep.json";
  std::ofstream(file) << text;
  return read_sweep_file(file);
}

}  // namespace

TEST_CASE("a grid runs every combination, named by its values") {
  const SweepPlan plan = plan_of(
      {"fluid.viscosity=0.1,1e-3", "video.duration=0.5", "look.liquid_color=[1,0,0],[0, 0.5, 1]"});
  CHECK(names_of(plan) == std::vector<std::string>{"viscosity=0.1,liquid_color=1_0_0",
                                                   "viscosity=0.1,liquid_color=0_0.5_1",
                                                   "viscosity=0.001,liquid_color=1_0_0",
                                                   "viscosity=0.001,liquid_color=0_0.5_1"});
  CHECK(plan.keys == std::vector<std::string>{"fluid.viscosity", "look.liquid_color"});
  CHECK(plan.runs[2].scene.simulation.fluid.viscosity == 0.001f);
  CHECK(plan.runs[3].scene.look.liquid_color.y == 0.5f);
  for (const SweepRun& run : plan.runs)
    CHECK(run.scene.video.duration == 0.5);
}

TEST_CASE("spaces around keys and values are no part of them") {
  const SweepPlan plan = plan_of({" look.style = mesh, particles", "fluid.viscosity= 1"});
  CHECK(names_of(plan) == std::vector<std::string>{"style=mesh", "style=particles"});
}

TEST_CASE("runs that differ in the picture alone share a simulation") {
  const SweepPlan plan = plan_of({"fluid.viscosity=0.1,1", "surface.smoothing=0,5"});
  CHECK(plan.runs[0].simulation == plan.runs[1].simulation);
  CHECK(plan.runs[2].simulation == plan.runs[3].simulation);
  CHECK(plan.runs[0].simulation != plan.runs[2].simulation);
}

TEST_CASE(
    "runs whose probes are read between frames share a simulation only with the same probes") {
  const std::string probes =
      R"(probes=[{"name":"a","volume":{}}],[{"name":"b","front":{"direction":"+x"}}])";
  const SweepPlan each_frame = plan_of({probes}), between = plan_of({probes, "probes_rate=200"});
  CHECK(each_frame.runs[0].simulation == each_frame.runs[1].simulation);
  CHECK(between.runs[0].simulation != between.runs[1].simulation);
}

TEST_CASE("keys with the same last part are named in full, and odd values by a hash") {
  const SweepPlan plan = plan_of({"domain.max[1]=0.75,0.8", "fluid.viscosity=0.1,0.2"});
  CHECK(plan.runs[0].name == "max[1]=0.75,viscosity=0.1");
  const SweepPlan both = plan_of(
      {"fluid.viscosity=0.1,0.2", "obstacles[0].wall_viscosity=0,1", "fluid.wall_viscosity=0,1"});
  CHECK(both.runs[0].name == "viscosity=0.1,obstacles[0].wall_viscosity=0,fluid.wall_viscosity=0");
  const SweepPlan odd = plan_of({R"(name="a b","c d")"});
  CHECK(odd.runs[0].name.find_first_of("/ ") == std::string::npos);
  CHECK(odd.runs[0].name != odd.runs[1].name);
}

TEST_CASE("a sweep that makes no sense is refused") {
  CHECK_THROWS_WITH(plan_of({"fluid.viscosity=1"}), Contains("nothing varies"));
  CHECK_THROWS_WITH(plan_of({"fluid.viscosity=1,1.0"}), Contains("two runs have the same values"));
  CHECK_THROWS_WITH(plan_of({"fluid.viscosity=1,2", "fluid.viscosity=3,4"}),
                    Contains("fluid.viscosity is varied twice"));
  CHECK_THROWS_WITH(plan_of({"fluid.viscosity=1,thick"}),
                    Contains("--set fluid.viscosity=1,thick: fluid.viscosity: expected a number"));
  CHECK_THROWS_WITH(
      plan_of({"fluid.viscosity=1,2", "domain.max[0]=1.2,0.4"}),
      Contains("is outside the domain") && Contains("(in the run viscosity=1,max[0]=0.4)"));
  CHECK_THROWS_WITH(parse_sweep_target("front_m"), Contains("METRIC=NUMBER"));
  CHECK_THROWS_WITH(parse_sweep_target("front_m=far"), Contains("METRIC=NUMBER"));
}

TEST_CASE("the reference is found by its name or by values that it alone has") {
  const std::vector<std::string> grid{"fluid.viscosity=0.1,1", "surface.smoothing=0,5"};
  CHECK(plan_of(grid, "viscosity=1,smoothing=0").reference == 2);
  CHECK(plan_of(grid, "smoothing=0,viscosity=1.0").reference == 2);
  CHECK(plan_of(grid, "surface.smoothing=5,fluid.viscosity=0.1").reference == 1);
  CHECK_THROWS_WITH(plan_of(grid, "viscosity=1"), Contains("2 runs have these values"));
  CHECK_THROWS_WITH(plan_of(grid, "viscosity=2"), Contains("there is no such run"));
}

TEST_CASE("a Latin hypercube meets each part of each range once, and a seed gives one hypercube") {
  const int n = 20;
  const auto samples = [&](int seed) {
    return samples_of({.samples = n,
                       .seed = seed,
                       .ranges = {{"a", {.min = 0, .max = 1}},
                                  {"b", {.min = 1e-4, .max = 1, .scale = RangeScale::logarithmic}},
                                  {"c", {.min = 1, .max = 20, .whole = true}}}});
  };
  const SweepAxis axis = samples(7);
  std::set<int> a, b, c;
  for (const SweepValues& row : axis) {
    a.insert(std::min(n - 1, static_cast<int>(row[0].value.get<double>() * n)));
    b.insert(
        std::min(n - 1, static_cast<int>((std::log10(row[1].value.get<double>()) + 4) / 4 * n)));
    REQUIRE(row[2].value.is_number_integer());
    c.insert(row[2].value.get<int>());
  }
  CHECK(a.size() == n);
  CHECK(b.size() == n);
  CHECK(c.size() == n);
  CHECK(*c.begin() == 1);
  CHECK(*c.rbegin() == 20);
  const auto values = [&](int seed) {
    std::string text;
    for (const SweepValues& row : samples(seed))
      for (const SweepValue& v : row)
        text += v.value.dump() + " ";
    return text;
  };
  CHECK(values(7) == values(7));
  CHECK(values(7) != values(8));
}

TEST_CASE("a sweep file says what varies; grid, list and hypercube are combined") {
  const TemporaryFolder folder;
  const auto request = read_text(folder, R"({
    "scene": "a.json", "set": {"video.duration": 1},
    "grid": {"fluid.viscosity": [1, 2]},
    "list": [{"look.style": "mesh"}, {"look.style": "particles", "look.color_by": "density"}, {}],
    "latin_hypercube": {"samples": 4, "seed": 3, "ranges": {"solver.cfl": {"min": 0.1, "max": 0.4}}},
    "reference": "viscosity=1", "targets": {"steps": 100}, "times": [0.1, 0.5]
  })");
  REQUIRE(request);
  CHECK(request->scene == folder / "a.json");
  std::vector<std::size_t> sizes;
  for (const SweepAxis& axis : request->axes)
    sizes.push_back(axis.size());
  CHECK(sizes == std::vector<std::size_t>{1, 2, 3, 4});
  CHECK(request->targets.front().key == "steps");
  CHECK(request->times == std::vector<double>{0.1, 0.5});
}

TEST_CASE("a scene is no sweep") {
  CHECK_FALSE(read_sweep_file(small_scene));
  CHECK_THROWS_WITH(read_sweep_file("no_such_file.json"), Contains("there is no such file"));
}

TEST_CASE("a wrong sweep file is refused with the place and what is accepted") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& text, const std::string& message) {
    CHECK_THROWS_WITH(read_text(folder, text), Contains(message));
  };
  refused(R"({"grid": {"a": [1]}})", "\"scene\" is missing");
  refused(R"({"scene": "a.json", "lst": []})",
          "sweep.json:1:21: lst: unknown key; did you mean \"list\"?");
  refused(R"({"scene": 3})", "sweep.json:1:2: scene: expected text, found 3");
  refused(R"({"scene": "a", "grid": {"fluid.viscosity": 3}})",
          "sweep.json:1:25: grid.fluid.viscosity: expected a list [...]");
  refused(R"({"scene": "a", "list": [3]})", "list[0]: expected an object");
  refused(R"({"scene": "a", "latin_hypercube": {"samples": 1.5, "ranges": {}}})",
          "latin_hypercube.samples: 1.5 is out of range; accepted: 2 ... 10000");
  refused(R"({"scene": "a", "latin_hypercube": {"samples": 2.5, "ranges": {}}})",
          "latin_hypercube.samples: 2.5 is not a whole number; accepted: 2 ... 10000");
  refused(R"({"scene": "a", "latin_hypercube": {"sample": 3}})",
          "latin_hypercube: \"ranges\" is missing (ranges of values, by key of the scene)");
  refused(
      R"({"scene": "a", "latin_hypercube": {"samples": 3, "ranges": {"a": {"min": 1, "max": 2, "scale": "log"}}}})",
      "unknown value \"log\"; accepted: linear, logarithmic");
  refused(R"({"scene": "a", "times": ["now"]})", "times[0]: expected a number");
  refused(R"({"scene": "a", "times": []})", "times: expected a list [...] of at least one entry");
  refused(R"({"scene": "a", "list": []})", "list: expected a list [...] of at least one entry");
  refused(R"({"scene": "a", "grid": {"b": [1], "a": []}})",
          "sweep.json:1:35: grid.a: expected a list [...] of at least one entry");
  refused(R"({"scene": "a", "set": [1]})", "set: expected an object {...}, found the list [1]");
  refused(R"({"scene": "a", "targets": {"steps": "few"}})",
          "sweep.json:1:28: targets.steps: expected a number (any), found \"few\"");
  refused(R"({"set": {"a": 1}})", "\"scene\" is missing (the scene file, its path");
}

TEST_CASE("a range whose ends, scale and kind of numbers do not fit each other is refused") {
  const TemporaryFolder folder;
  const auto refused = [&](const std::string& range, const std::string& message) {
    CHECK_THROWS_WITH(
        read_text(folder, R"({"scene": "a", "latin_hypercube": {"samples": 3, "ranges":
{"a.b": )" + range + "}}}"),
        Contains("sweep.json:2:" + message));
  };
  const std::string at = ": latin_hypercube.ranges.a.b.";
  refused(R"({"min": 1, "max": 1})", "20" + at + "max: must be above min");
  refused(R"({"min": 0.5, "max": 3, "whole": true})",
          "10" + at + "min: 0.5 is out of range; accepted: whole numbers, -1000000 ... 1000000");
  refused(R"({"min": 1, "max": 1000001, "whole": true})",
          "20" + at + "max: 1000001 is out of range; accepted: whole numbers");
  for (const char* range : {R"({"min": 0, "max": 1, "scale": "logarithmic"})",
                            R"({"min": 1, "max": 2, "scale": "logarithmic", "whole": true})"})
    refused(range, "30" + at + "scale: logarithmic needs a min above 0");
  CHECK_THROWS_WITH(read_text(folder, R"({"scene": "a", "latin_hypercube": {"samples": 3, "ranges":
{"a": {"min": "low", "max": -1, "whole": true}, "b": {"max": -1, "scale": "logarithmic"}}}})"),
                    Contains("a.min: expected a number") && Contains("b: \"min\" is missing") &&
                        !Contains("must be above") && !Contains("out of range") &&
                        !Contains("logarithmic needs"));
}

TEST_CASE("values, ranges and targets of a sweep file are complained of where they stand in it") {
  const TemporaryFolder folder;
  std::filesystem::copy_file(small_scene, folder / "a.json");
  const auto complaint = [&](const std::string& rest) -> std::string {
    try {
      check_targets(plan_sweep(*read_text(folder, R"({"scene": "a.json", )" + rest + "}")));
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  };
  CHECK_THAT(complaint(R"("grid": {"fluid.viscosity": [1,
"thick"]})"),
             Contains("sweep.json:2:1: grid.fluid.viscosity[1]: fluid.viscosity: expected"));
  CHECK_THAT(complaint(R"("list": [{}, {"fluid.viscosity": "thick"}])"),
             Contains("sweep.json:1:35: list[1].fluid.viscosity: fluid.viscosity: expected"));
  CHECK_THAT(complaint(R"("set": {"solver.cfl": 7}, "grid": {"fluid.viscosity": [1, 2]})"),
             Contains("sweep.json:1:29: set.solver.cfl: solver.cfl: 7 is out of range"));
  CHECK_THAT(
      complaint(
          R"("latin_hypercube": {"samples": 2, "ranges": {"solver.cfl": {"min": 7, "max": 8}}})"),
      Contains("sweep.json:1:66: latin_hypercube.ranges.solver.cfl: solver.cfl: 7"));
  CHECK_THAT(complaint(R"("grid": {"fluid.viscosity": [1, 2]}, "targets": {"stepps": 3})"),
             Contains("sweep.json:1:70: targets.stepps: there is no such figure; did you mean"));
}

TEST_CASE("all that is wrong with a sweep is told at once, what several runs share once") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH(
      read_text(folder, R"({"scene": 3, "lst": [],
                            "latin_hypercube": {"samples": 1.5, "ranges": {"a": {"min": 2, "max": 1, "hole": 1}}}})"),
      Contains("sweep.json:1:2: scene: expected text") &&
          Contains("sweep.json:1:14: lst: unknown key") &&
          Contains("sweep.json:2:49: latin_hypercube.samples: 1.5 is out of range") &&
          Contains("latin_hypercube.ranges.a.max: must be above min") &&
          Contains("latin_hypercube.ranges.a.hole: unknown key; did you mean \"whole\"?"));
  const std::string message = [] {
    try {
      plan_of({"fluid.viscosity=1,thick", "solver.cfl=0.3,7", "look.stile=mesh"});
    } catch (const SceneError& error) {
      return std::string(error.what());
    }
    return std::string();
  }();
  INFO(message);
  CHECK(std::count(message.begin(), message.end(), '\n') == 2);
  CHECK(message.find("--set fluid.viscosity=1,thick: fluid.viscosity: expected a number") !=
        message.npos);
  CHECK(message.find("--set solver.cfl=0.3,7: solver.cfl: 7 is out of range") != message.npos);
  CHECK(message.find("--set look.stile=mesh: look.stile: unknown key") != message.npos);
}

TEST_CASE("the sweeps that ship can be run") {
  int shipped = 0;
  for (const auto& entry : std::filesystem::directory_iterator(source / "scenes/sweeps")) {
    if (entry.path().filename() == "sweep.schema.json")
      continue;
    INFO(entry.path().string());
    const auto request = read_sweep_file(entry.path());
    REQUIRE(request);
    const SweepPlan plan = plan_sweep(*request);
    CHECK_NOTHROW(check_targets(plan));
    CHECK(plan.runs.size() > 4);
    ++shipped;
  }
  CHECK(shipped >= 2);
}

TEST_CASE("scenes/sweeps/sweep.schema.json is the program's") {
  INFO("to make it anew: ./spindrift schema --sweep > scenes/sweeps/sweep.schema.json");
  std::ifstream file(source / "scenes/sweeps/sweep.schema.json");
  const std::string shipped{std::istreambuf_iterator<char>(file), {}};
  CHECK(shipped == to_text(sweep_schema()));
}

TEST_CASE("few runs are compared each with each, many with the reference alone") {
  CHECK(pairs_of(plan_of({"fluid.viscosity=1,2,3", "surface.smoothing=0,1,2"})).size() == 36);
  const std::vector<std::string> many{"fluid.viscosity=1,2,3,4", "surface.smoothing=0,1,2,3"};
  CHECK(pairs_of(plan_of(many)).empty());
  const auto pairs = pairs_of(plan_of(many, "viscosity=2,smoothing=1"));
  CHECK(pairs.size() == 15);
  CHECK(std::all_of(pairs.begin(), pairs.end(), [](const SweepPair& p) { return p.all_frames; }));
  CHECK(pairs_of(plan_of({"video.width=160,320"})).empty());
}

TEST_CASE("runs whose records or probes are damaged are done anew, or have no figures") {
  const TemporaryFolder root;
  SweepPlan plan = plan_of({"fluid.viscosity=1,2"});
  const SweepRun& run = plan.runs.front();
  const SweepFolder folder(root / "");
  const auto place = folder.run(run);
  std::filesystem::create_directories(place);
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(place / name) << text;
  };
  write("video.mp4", "");
  const Json whole{{"complete", true},
                   {"simulation_hash", simulation_hash(run.scene)},
                   {"versions", versions_json()},
                   {"scene", to_json(run.scene)}};
  write("run.json", whole.dump());
  CHECK(folder.is_drawn(run));
  for (const char* text : {"", "[]", "3", "{", "\xff\xfe"}) {
    write("run.json", text);
    CHECK_FALSE(folder.is_drawn(run));
  }
  for (const char* key : {"complete", "simulation_hash", "versions", "scene"})
    for (const Json& value : {Json("yes"), Json(1), Json::array({1}), Json::object(), Json()}) {
      Json damaged = whole;
      damaged[key] = value;
      write("run.json", damaged.dump());
      CHECK_FALSE(folder.is_drawn(run));
    }

  Json damaged = whole;
  damaged["steps"] = "many";
  write("run.json", damaged.dump());
  write("probes.csv", "time_s,front_m\n0,1\n0.1,one\n,1e999\n0.3,4,5,6\n");
  plan.runs.front().scene.probes.emplace_back();
  damaged["scene"] = to_json(plan.runs.front().scene);
  write("run.json", damaged.dump());
  const SweepResult result = read_results(plan, folder, {"", ""}).front();
  CHECK(result.figures.at("steps") == 0);
  CHECK(result.figures.at("front_m") == 4);
}

}  // namespace app_sweep_tests
