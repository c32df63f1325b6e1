// Probes of a scene: their keys, the times at which they are read, their table and their report.
#include <algorithm>
#include <catch2/catch.hpp>
#include <limits>
#include <string>
#include <vector>

#include "app/run/probe_table.hpp"
#include "app/scene/scene_fields.hpp"
#include "page_support.hpp"

namespace app_probes_tests {

using namespace spindrift;
using namespace spindrift::app;

namespace {

const char* const probed_scene = R"({"probes": [
  {"name": "gauge", "surface_height": {"x": 0.5, "z": 0.4}},
  {"name": "tap-1", "pressure": {"point": [0.5, 0.1, 0.4]}},
  {"name": "front", "front": {"direction": "-z"}},
  {"name": "all", "energy": {}},
  {"name": "water", "volume": {}}], "probes_rate": 250})";

}  // namespace

TEST_CASE("probes are read from a scene, and the resolved scene is the same one") {
  const Scene scene = parse_scene(probed_scene, "test.json");
  REQUIRE(scene.probes.size() == 5);
  CHECK(scene.probes_rate == 250);
  CHECK(scene.probes[1].name == "tap-1");
  CHECK(std::get<sim::SurfaceHeightProbe>(scene.probes[0].quantity).z == 0.4f);
  CHECK(std::get<sim::PressureProbe>(scene.probes[1].quantity).point ==
        glm::vec3(0.5f, 0.1f, 0.4f));
  CHECK(std::get<sim::FrontProbe>(scene.probes[2].quantity).direction == sim::Direction::minus_z);
  CHECK(std::holds_alternative<sim::EnergyProbe>(scene.probes[3].quantity));
  CHECK(std::holds_alternative<sim::VolumeProbe>(scene.probes[4].quantity));
  const auto resolved = to_json(scene);
  CHECK(resolved.at("probes").at(3).dump() == R"({"name":"all","energy":{}})");
  CHECK(to_json(parse_scene(resolved.dump(), "test.json")) == resolved);
}

TEST_CASE("the schema knows every kind of probe") {
  const auto probe = scene_schema()["properties"]["probes"]["items"];
  CHECK(probe["oneOf"].size() == alternative_names<sim::ProbeQuantity>.size());
  CHECK(probe["required"].dump() == R"(["name"])");
  CHECK(probe["properties"]["energy"]["additionalProperties"] == false);
  CHECK(probe["properties"]["front"]["properties"]["direction"]["enum"].size() == 6);
}

TEST_CASE("particles depend on probes only where their readings end steps") {
  Scene scene = parse_scene(probed_scene, "test.json");
  const std::string read_apart = simulation_hash(scene);
  scene.probes_rate = 0;
  const std::string read_with_pictures = simulation_hash(scene);
  CHECK(read_apart != read_with_pictures);
  scene.probes.clear();
  CHECK(simulation_hash(scene) == read_with_pictures);
  scene.probes_rate = 250;
  CHECK(simulation_hash(scene) == read_with_pictures);
}

TEST_CASE("readings are due at whole periods, each once, whatever the frames' times") {
  CHECK(reading_times(-1, 0, 10) == std::vector<double>{0});
  CHECK(reading_times(0, 0.05, 10).empty());
  const double rate = GENERATE(7., 29.97, 30., 60., 90., 1000.);
  std::vector<double> all;
  for (int frame = 0; frame <= 60; ++frame) {
    const double begin = frame == 0 ? -1 : (frame - 1) / 30., end = frame / 30.;
    for (const double time : reading_times(begin, end, rate)) {
      CHECK((time > begin && time <= end));
      all.push_back(time);
    }
  }
  REQUIRE(all.size() == static_cast<std::size_t>(2 * rate + 1e-6) + 1);
  for (std::size_t k = 0; k < all.size(); ++k)
    CHECK(all[k] == Approx(static_cast<double>(k) / rate));
}

TEST_CASE("a simulation stops for readings no more often than there are readings or frames") {
  const double rate = GENERATE(25., 60., 240., 250., 500., 510., 1000.);
  const double frames_per_second = 60;
  const int frames = 96;
  std::size_t stops = 0, readings = 0;
  for (int frame = 1; frame <= frames; ++frame) {
    const double begin = (frame - 1) / frames_per_second, end = frame / frames_per_second;
    const std::vector<double> due = reading_times(begin, end, rate);
    const std::vector<double> times = stop_times(begin, end, due.size());
    CHECK(times.back() == end);
    CHECK(std::is_sorted(times.begin(), times.end()));
    if (std::fmod(rate, frames_per_second) == 0)
      CHECK_THAT(times, Catch::Approx(due));
    stops += times.size();
    readings += due.size();
  }
  CHECK(stops == std::max(readings, std::size_t{frames}));
}

TEST_CASE("what is read between two stops lies on the straight line between them") {
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const ProbeReading before{0.1, {1, nothing, nothing}}, after{0.2, {5, 3, nothing}};
  const ProbeReading between = reading_between(before, after, 0.125);
  CHECK(between.time == 0.125);
  CHECK(between.values[0] == Approx(2));
  CHECK(std::isnan(between.values[1]));
  const ProbeReading last = reading_between(before, after, 0.2);
  CHECK(last.values[0] == 5);
  CHECK(last.values[1] == 3);
  CHECK(std::isnan(last.values[2]));
}

TEST_CASE("the table has a column for every number, with its unit, and empty cells") {
  Scene scene = parse_scene(probed_scene, "test.json");
  scene.probes.resize(4);
  const double nothing = std::numeric_limits<double>::quiet_NaN();
  const std::vector<ProbeReading> readings{{0, {nothing, 0, 0.25, 1, 2, 3}},
                                           {0.1, {0.5, 1e5, nothing, 4, 5, 9}}};
  CHECK(probes_csv(scene, readings) ==
        "time_s,gauge_m,tap-1_Pa,front_m,all_kinetic_J,all_potential_J,all_total_J\n"
        "0,,0,0.25,1,2,3\n"
        "0.1,0.5,100000,,4,5,9\n");
  CHECK(probes_csv(scene, {}).find('\n') == probes_csv(scene, {}).size() - 1);
}

TEST_CASE("the report plots every probe, a unit a plot, and keeps the peaks of many readings") {
  const Scene scene = parse_scene(probed_scene, "test.json", {"name=<b>"});
  std::vector<ProbeReading> readings;
  for (int k = 0; k < 50'000; ++k) {
    readings.push_back({k / 250., std::vector<double>(13, 1.)});
    readings.back().values[0] = std::numeric_limits<double>::quiet_NaN();
  }
  readings[31'234].values[1] = 7e4;
  readings[31'235].values[1] = -3;
  const std::string html = probes_html(scene, readings);
  const auto plots = test::plots_in(html);
  REQUIRE(plots.size() == 6);         // height, pressure, front, energies, volume and its bounds
  CHECK(plots[0]["curves"].empty());  // there was nothing to measure
  CHECK(plots[1]["y_label"] == "Pa");
  CHECK(!plots[1]["y_from_zero"]);
  CHECK(plots[3]["curves"].size() == 3);
  CHECK(plots[4]["y_label"] == "m³");
  CHECK(plots[5]["curves"].size() == 6);
  const auto& curve = plots[1]["curves"][0];
  CHECK(!curve["dashed"]);
  double highest = 0, lowest = 0, last = -1;
  for (const auto& point : curve["points"]) {
    CHECK(point[0] > last);
    last = point[0];
    highest = std::max<double>(highest, point[1]);
    lowest = std::min<double>(lowest, point[1]);
  }
  CHECK(curve["points"].size() < 2100);
  CHECK(highest == 7e4);
  CHECK(lowest == -3);
  CHECK_THAT(html, Catch::Contains("Probes of &lt;b&gt;") && !Catch::Contains("<b>") &&
                       Catch::Contains("<h2>tap-1</h2>") && Catch::EndsWith("</html>\n"));
}

}  // namespace app_probes_tests
