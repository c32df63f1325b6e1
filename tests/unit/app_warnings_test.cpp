// What a scene is warned of before it is simulated, and what it is not.
#include <catch2/catch.hpp>
#include <string>

#include "app/checks/estimate.hpp"
#include "app/checks/scene_warnings.hpp"
#include "app/scene/scene.hpp"

namespace app_warnings_tests {

using namespace spindrift::app;

namespace {

/// A tank of 1 x 1 x 0.5 m with the given entries; without volumes of their own it holds 250
/// litres.
Scene tank(const std::string& entries, const std::string& fluid = R"(
    "volumes": [{"box": {"min": [0, 0, 0], "max": [1, 0.5, 0.5]}}])") {
  return parse_scene(R"({"domain": {"min": [0, 0, 0], "max": [1, 1, 0.5]}, "video": {"duration": 1},
                         "fluid": {"spacing": 0.05, )" +
                         fluid + "}" + entries + "}",
                     "tank.json");
}

/// "path: message" of each warning, a line each.
std::string warnings(const Scene& scene) {
  std::string text;
  for (const Diagnostic& warning : warnings_of(scene))
    text += warning.path + ": " + warning.message + "\n";
  return text;
}

std::string emitter(const std::string& center, const std::string& from) {
  return R"("emitters": [{"disc": {"center": )" + center +
         R"(, "direction": [0, -1, 0], "radius": 0.1}, "speed": 1, "from": )" + from + "}]";
}

}  // namespace

TEST_CASE("a scene that gets what it asks for is not warned of anything") {
  CHECK(warnings(tank("")).empty());
  CHECK(warnings(tank("", emitter("[0.5, 0.7, 0.25]", "0"))).empty());
}

TEST_CASE("obstacles that are outside the domain all the time are told, and not counted") {
  const std::string outside = R"({"box": {"min": [5, 0, 0], "max": [5.3, 0.3, 0.3]})";
  const Scene away = tank(R"(, "obstacles": [)" + outside + "}]");
  CHECK_THAT(warnings(away), Catch::Contains("obstacles[0]: is outside the domain all the time"));
  CHECK(estimate(away, 1).boundary_particles == estimate(tank(""), 1).boundary_particles);
  const std::string coming = R"(, "motion": {"keyframes": [
      {"time": 0, "translate": [0, 0, 0]}, {"time": 1, "translate": [-4.8, 0.6, 0]}]})";
  CHECK(warnings(tank(R"(, "obstacles": [)" + outside + coming + "}]")).empty());
}

TEST_CASE("liquid that has no place is told in litres") {
  const std::string ball =
      R"(, "obstacles": [{"sphere": {"center": [0.5, 0.2, 0.25], "radius": 0.15}}])";
  CHECK_THAT(warnings(tank(ball)),
             Catch::Contains("fluid.volumes[0]: ") &&
                 Catch::Contains(" of its 250 litres are in obstacles[0] and left out"));
  const auto ball_of = [](const std::string& radius) {
    return tank(
        "", R"("volumes": [{"sphere": {"center": [0.5, 0.4, 0.25], "radius": )" + radius + "}}]");
  };
  CHECK_THAT(warnings(ball_of("0.06")), Catch::Contains("0.905 litres are asked for, "));
  CHECK(warnings(ball_of("0.2")).empty());
}

TEST_CASE("emitters that can bring nothing are told") {
  CHECK_THAT(
      warnings(tank("", R"("volumes": [{"box": {"min": [0, 0, 0], "max": [1, 0.9, 0.5]}}], )" +
                            emitter("[0.5, 0.4, 0.25]", "0"))),
      Catch::Contains("fluid.emitters[0]: its nozzle, four spacings behind the opening, is "
                      "in fluid.volumes[0]"));
  CHECK_THAT(warnings(tank("", emitter("[0.5, 0.7, 0.25]", "5"))),
             Catch::Contains("fluid.emitters[0]: brings nothing: its first liquid comes out at "
                             "5.0") &&
                 Catch::Contains("and the end is at 1 s"));
}

}  // namespace app_warnings_tests
