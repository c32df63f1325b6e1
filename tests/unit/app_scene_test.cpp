// Scene files: what ships, what the defaults are, what the hash depends on.
#include <catch2/catch.hpp>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "app/checks/estimate.hpp"
#include "app/checks/scene_warnings.hpp"
#include "app/scene/scene.hpp"
#include "app/scene/scene_fields.hpp"
#include "app/tables/document.hpp"
#include "app/tables/values.hpp"
#include "sim/run/simulation.hpp"
#include "sim/start/initial.hpp"

namespace app_scene_tests {

using namespace spindrift;
using namespace spindrift::app;

namespace {

const std::filesystem::path scenes = std::filesystem::path(SOURCE_DIR) / "scenes";

std::vector<std::filesystem::path> shipped_scenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(scenes))
    if (entry.path().extension() == ".json" && entry.path().filename() != "scene.schema.json")
      files.push_back(entry.path());
  return files;
}

Scene parse(const std::string& text, const Overrides& overrides = {}) {
  return parse_scene(text, "test.json", overrides);
}

std::string hash_with(const Overrides& overrides) {
  return simulation_hash(parse("{}", overrides));
}

}  // namespace

TEST_CASE("an empty scene has every default and the file's name") {
  const Scene scene = parse("{} // nothing but a comment");
  Scene defaults;
  defaults.name = "test";
  CHECK(to_json(scene) == to_json(defaults));
  CHECK(scene.video.frame_count() == 120);
}

TEST_CASE("every shipped scene loads, refers to the schema and is short") {
  CHECK(shipped_scenes().size() >= 5);
  for (const auto& file : shipped_scenes()) {
    INFO(file);
    const Scene scene = read_scene(file);
    CHECK(scene.name == file.stem());
    CHECK(sim::fill_volumes(scene.simulation).positions.size() > 1000);
    std::ifstream stream(file);
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    CHECK(text.find("\"$schema\": \"scene.schema.json\"") != std::string::npos);
    CHECK(std::count(text.begin(), text.end(), '\n') <= 20);
  }
}

TEST_CASE("the demo has about 30 thousand particles and 120 pictures of 1280x720") {
  const Scene scene = read_scene(scenes / "dam_break.json");
  const auto particles = sim::fill_volumes(scene.simulation).positions.size();
  CHECK(particles > 28000);
  CHECK(particles < 32000);
  CHECK(scene.video.frame_count() == 120);
  CHECK(scene.video.width == 1280);
  CHECK(scene.video.height == 720);
}

TEST_CASE("drop_44k has 44,294 particles on the source report's lattice") {
  const Scene scene = read_scene(scenes / "drop_44k.json");
  const auto particles = sim::fill_volumes(scene.simulation);
  CHECK(particles.positions.size() == 44294);
  glm::vec3 low{1e9f}, high{-1e9f};
  for (const glm::vec3& p : particles.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  const glm::vec3 expected_low{-2.45f, 0.f, 0.f}, expected_high{2.5f, 5.f, 5.f};
  CHECK(glm::distance(low, expected_low) < 1e-4f);
  CHECK(glm::distance(high, expected_high) < 1e-4f);
  CHECK(scene.video.frame_count() == 90);
}

TEST_CASE("a resolved scene reads back as itself") {
  for (const auto& file : shipped_scenes()) {
    INFO(file);
    const auto resolved = to_json(read_scene(file));
    CHECK(to_json(parse_scene(to_text(resolved), file)) == resolved);
  }
  const auto rich = to_json(parse(R"({
    "name": "rich",
    "fluid": {"volumes": [
      {"cylinder": {"from": [1, 0.5, 0.4], "to": [1, 1, 0.4], "radius": 0.2}, "velocity": [1, 2, 3]},
      {"sphere": {"center": [2, 1, 0.4], "radius": 0.3}}],
      "emitters": [
        {"disc": {"center": [0.2, 1.5, 0.4], "direction": [1, 0, 0], "radius": 0.1}, "to": 3},
        {"rectangle": {"center": [0.2, 1, 0.4], "direction": [1, 0, 0], "width": 0.2,
                       "height": 0.1}, "speed": 2, "from": 1, "max_particles": 5000}]},
    "domain": {"open": ["+y", "-x"]},
    "sinks": [{"box": {"min": [3, 0, 0], "max": [3.2, 0.1, 0.8]}}],
    "obstacles": [{"sphere": {"center": [3, 0, 0.4], "radius": 0.1}},
                  {"capsule": {"from": [2, 0, 0.4], "to": [2.5, 0, 0.4], "radius": 0.1}}],
    "forces": {"body": [{"time": 0, "acceleration": [1, 0, 0]},
                        {"time": 2.5, "acceleration": [0.1, 0, 0]}]},
    "solver": {"type": "sph", "pressure_kernel": "spiky"},
    "camera": {"position": [0, 1, 5], "target": [1, 0.5, 0]},
    "look": {"style": "particles", "color_by": "pressure", "floor": false}})"));
  CHECK(to_json(parse(to_text(rich))) == rich);
  CHECK(rich["camera"]["keyframes"].size() == 1);
  CHECK(rich["solver"]["type"] == "sph");
}

TEST_CASE("a number is dumped as it was written") {
  const std::string text =
      to_text(to_json(parse(R"({"fluid": {"spacing": 0.1, "viscosity": 3e-4}})")));
  CHECK(text.find("\"spacing\": 0.1,") != std::string::npos);
  CHECK(text.find("\"viscosity\": 0.0003,") != std::string::npos);
}

TEST_CASE("an override sets any value, in the words of scene files") {
  CHECK(parse("{}", {"fluid.viscosity=0.05"}).simulation.fluid.viscosity == 0.05f);
  CHECK(parse("{}", {"look.style=particles"}).look.style == gl::Style::particles);
  CHECK(parse("{}", {"look.style=\"particles\""}).look.style == gl::Style::particles);
  CHECK(parse("{}", {"domain.max=[4, 2, 1]"}).simulation.domain.max.x == 4.f);
  CHECK(parse("{}", {"domain.max=[4,2,1]", "domain.max[1]=3"}).simulation.domain.max.y == 3.f);
  CHECK(parse("{}", {"name=other"}).name == "other");
  CHECK(parse("{}", {"look.floor=false"}).look.floor == false);
  for (const std::string key : {"fluid.volumes[0].velocity", "fluid.volumes.0.velocity"}) {
    const Scene scene = parse("{}", {key + "=[1, 0, 0]"});
    REQUIRE(scene.simulation.fluid.volumes.size() == 1);
    CHECK(scene.simulation.fluid.volumes[0].velocity.x == 1.f);
    CHECK(std::get<sim::Box>(scene.simulation.fluid.volumes[0].shape).max.z == 0.8f);
  }
  const Scene two =
      parse("{}", {R"(fluid.volumes[1]={"sphere":{"center":[2,1,0.4],"radius":0.3}})"});
  CHECK(two.simulation.fluid.volumes.size() == 2);
}

TEST_CASE("the hash knows what moves the liquid and nothing else") {
  const std::string hash = hash_with({});
  CHECK(hash.size() == 32);
  CHECK(hash == hash_with({}));
  for (const char* picture :
       {"name=other", "camera.position=[1,2,3]", "look.style=particles", "light.intensity=2",
        "video.width=640", "video.duration=1", "video.quality=30", "surface.cell_size=1"}) {
    INFO(picture);
    const bool camera = std::string(picture).starts_with("camera");
    CHECK(hash == (camera ? hash_with({picture, "camera.target=[0,0,0]"}) : hash_with({picture})));
  }
  for (const char* motion :
       {"fluid.spacing=0.03", "fluid.viscosity=0.02", "domain.max=[3.3,2,0.8]", "solver.cfl=0.3",
        "forces.gravity=[0,-9.8,0]", "fluid.volumes[0].velocity=[0,0,0.1]", "solver.type=sph",
        "video.frames_per_second=25",
        R"(obstacles=[{"sphere":{"center":[2,0,0.4],"radius":0.1}}])"}) {
    INFO(motion);
    CHECK(hash != hash_with({motion}));
  }
}

TEST_CASE("the hash of the same settings is the same however they are written") {
  CHECK(simulation_hash(parse(R"({"fluid": {"spacing": 0.0250, "viscosity": 1e-2}})")) ==
        simulation_hash(parse("{}")));
}

TEST_CASE("a speed of sound that lets the liquid be compressed is warned of") {
  const auto warnings = [](const std::string& speed, const std::string& type = "sph") {
    return warnings_of(parse("{}", {"solver.type=" + type, "solver.speed_of_sound=" + speed}));
  };
  const float fastest = std::sqrt(2 * 9.81f * 2);  // down the whole domain
  REQUIRE(warnings("0.01").size() == 1);
  CHECK(warnings("0.01")[0].message.starts_with("0.01 m/s is less than ten times"));
  CHECK(warnings("0.01")[0].message.find("from 62.6418 m/s on") != std::string::npos);
  CHECK(warnings(std::to_string(9.9f * fastest)).size() == 1);
  CHECK(warnings(std::to_string(10.1f * fastest)).empty());
  CHECK(warnings("0").empty());
  CHECK(warnings("0.01", "pcisph").empty());
}

TEST_CASE("a frame rate is exact") {
  const auto video = [](const std::string& rate, double duration = 1001) {
    return parse("{}",
                 {"video.frames_per_second=" + rate, "video.duration=" + std::to_string(duration)})
        .video;
  };
  CHECK(video("25").frames_per_second == FrameRate{25, 1});
  CHECK(video("29.97").frames_per_second == FrameRate{2997, 100});
  CHECK(video("\"60000/2002\"").frames_per_second == FrameRate{30000, 1001});
  CHECK(video("30000/1001").frame_count() == 30000);
  CHECK(video("30000/1001").frames_per_second.time_of(30000) == 1001.);
  CHECK(video("24000/1001", 1.001).frame_count() == 24);
  const auto rate_in_json = [](const std::string& rate) {
    const Scene scene = parse("{}", {"video.frames_per_second=" + rate});
    CHECK(parse(to_text(to_json(scene))).video.frames_per_second == scene.video.frames_per_second);
    return to_json(scene)["video"]["frames_per_second"];
  };
  CHECK(rate_in_json("30") == 30);
  CHECK(rate_in_json("30/1") == 30);
  CHECK(rate_in_json("12.5") == "25/2");
  CHECK(rate_in_json("30000/1001") == "30000/1001");
  CHECK(hash_with({"video.frames_per_second=30/1"}) == hash_with({}));
  CHECK(hash_with({"video.frames_per_second=30000/1001"}) != hash_with({}));
}

namespace {

/// Checks of all values of a document that their place in the text is that of the key or the value.
void check_places(const LocatedValue& value, const std::vector<std::string>& lines, int& checked) {
  const auto rest = [&](const LocatedValue& part) {
    const Place place = part.problem("").place;
    REQUIRE(place.line >= 1);
    REQUIRE(place.line <= lines.size());
    REQUIRE(place.column <= lines[place.line - 1].size());
    ++checked;
    return lines[place.line - 1].substr(place.column - 1);
  };
  if (value.json().is_object()) {
    value.for_each_member([&](const std::string& key, const LocatedValue& part) {
      CHECK(rest(part).starts_with(nlohmann::json(key).dump()));
      check_places(part, lines, checked);
    });
  }
  for (std::size_t k = 0; value.json().is_array() && k < value.json().size(); ++k) {
    const LocatedValue part = value[k];
    const std::string text = rest(part);
    if (part.json().is_number())
      CHECK(std::stod(text) == part.json().get<double>());
    else
      CHECK(text[0] == part.json().dump()[0]);
    check_places(part, lines, checked);
  }
}

}  // namespace

TEST_CASE("every value is found where it was written") {
  std::vector<std::string> texts{
      "[1,2 , -3e+2\t,[ [] ],{}/*,*/,\"a,]\\\"\",true , // ]\n null, 4// c\n,5/* \n */,6]",
      "{\"a\\\"b\" : {\"c\\\\\":[0.5]} /* \" */ , // \"\n \"d\":1e3, \"e\": \"\\\"f\" }"};
  for (const auto& file : shipped_scenes()) {
    std::ifstream stream(file);
    texts.emplace_back(std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>());
  }
  for (const std::string& text : texts) {
    INFO(text);
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
      lines.push_back(line);
    const SceneDocument document(text, "a.json");
    int checked = 0;
    check_places(document.value(), lines, checked);
    CHECK(checked >= 5);
  }
}

TEST_CASE("scenes/scene.schema.json is what the tables give") {
  std::ifstream stream(scenes / "scene.schema.json");
  const std::string shipped{std::istreambuf_iterator<char>(stream), {}};
  INFO("to make it anew: ./spindrift schema > scenes/scene.schema.json");
  CHECK(shipped == to_text(scene_schema()));
}

TEST_CASE("the schema refuses unknown keys everywhere and tells ranges, names and defaults") {
  const auto schema = scene_schema();
  CHECK(schema["additionalProperties"] == false);
  const auto& fluid = schema["properties"]["fluid"];
  CHECK(fluid["additionalProperties"] == false);
  CHECK(fluid["properties"]["spacing"]["maximum"] == 100.);
  CHECK(fluid["properties"]["spacing"]["default"] == 0.025);
  const auto& volume = fluid["properties"]["volumes"]["items"];
  CHECK(volume["additionalProperties"] == false);
  CHECK(volume["properties"].contains("sphere"));
  CHECK(volume["oneOf"].size() == alternative_names<sim::Shape>.size());
  CHECK(schema["properties"]["look"]["properties"]["style"]["enum"].size() == 2);
}

TEST_CASE("the estimate counts particles exactly and grows with the scene") {
  const Scene scene = read_scene(scenes / "drop_44k.json");
  const Estimate cost = estimate(scene, 1);
  CHECK(cost.particles == 44294);
  CHECK(cost.boundary_particles > 10000);
  CHECK(cost.bytes > 1e7);
  CHECK(cost.seconds > estimate(scene, 2).seconds);
  Scene longer = scene;
  longer.video.duration *= 3.;
  CHECK(estimate(longer, 1).seconds > 2. * cost.seconds);
}

TEST_CASE("a nozzle in a wall that is too thin is refused with the thickness that works") {
  const char* const text = R"({
    "fluid": {"spacing": 0.05, "volumes": [{"box": {"min": [0, 0, 0], "max": [0.3, 0.1, 1.2]}}],
              "emitters": [{"disc": {"center": [0.6, 0.25, 0.6], "direction": [0, 1, 0],
                                     "radius": 0.1}, "speed": 2.6}]},
    "domain": {"min": [0, 0, 0], "max": [1.2, 0.5, 1.2], "open": ["+y"]},
    "obstacles": [{"box": {"min": [0.45, 0, 0.45], "max": [0.75, 0.25, 0.75]}}]})";
  CHECK_THROWS_WITH(parse(text), Catch::Contains("fluid.emitters[0].disc") &&
                                     Catch::Contains("1.5 spacings (0.075 m) are needed"));
  CHECK_NOTHROW(parse(text, {"fluid.spacing=0.025"}));
  CHECK_NOTHROW(parse(
      text, {"obstacles.0.box.min=[0.425,0,0.425]", "obstacles.0.box.max=[0.775,0.25,0.775]"}));
  CHECK_NOTHROW(parse(text, {"obstacles=[]"}));  // in the air
}

TEST_CASE("a nozzle may be turned by 20 degrees from the face that it comes out of") {
  const auto turned = [](double degrees) {
    const double a = degrees * std::numbers::pi / 180, radius = 0.12;
    const auto text = [](double value) { return std::to_string(value); };
    parse(R"({"fluid": {"spacing": 0.04, "emitters": [{"speed": 1, "disc": {"radius": 0.12,
            "center": [0.4, )" +
          text(radius * std::sin(a)) + R"(, 0.3], "direction": [)" + text(std::sin(a)) + ", " +
          text(std::cos(a)) + R"(, 0]}}]},
          "domain": {"min": [0, 0, 0], "max": [1, 1, 0.6]}})");
  };
  for (const double degrees : {0., 10., 20.}) {
    INFO(degrees);
    CHECK_NOTHROW(turned(degrees));
  }
  for (const double degrees : {30., 45., 60., 75.}) {
    INFO(degrees);
    CHECK_THROWS_WITH(turned(degrees), Catch::Contains("within 20°"));
  }
}

TEST_CASE("emitters alone fill an empty domain, and what they bring is counted beforehand") {
  const char* const text = R"({
    "fluid": {"emitters": [{"rectangle": {"center": [1, 1.5, 0.4], "direction": [0, -1, 0],
                                          "up": [1, 0, 0], "width": 0.25, "height": 0.5},
                            "speed": 2, "from": 1}]},
    "video": {"duration": 3}})";
  const Scene scene = parse(text);
  CHECK(scene.simulation.fluid.volumes.empty());
  const double brought = 0.25 * 0.5 * 2 * 2 / std::pow(0.025, 3);
  CHECK(static_cast<double>(estimate(scene, 1).particles) == Approx(brought).epsilon(0.03));
  const Scene capped = parse(text, {"fluid.emitters.0.max_particles=1000"});
  CHECK(estimate(capped, 1).particles == 1000);
  CHECK(estimate(parse(text, {"video.duration=0.5"}), 1).particles == 0);
  CHECK(simulation_hash(capped) != simulation_hash(scene));
}

}  // namespace app_scene_tests
