// What a scene file's author is told of wrong keys and values: where they stand, and what is
// accepted.
#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "scene_errors_support.hpp"

namespace app_scene_errors_tests {

using namespace spindrift::app;

namespace {

struct Case {
  std::string text;
  std::vector<std::string> fragments;
};

const std::vector<Case> wrong_values{
    {R"({"fluid": {"spacng": 1}})", {"bad.json:1:12: fluid.spacng", "did you mean \"spacing\""}},
    {R"({"fluid": {"spaicng": 1}})", {"did you mean \"spacing\""}},
    {R"({"fluids": {}})", {"bad.json:1:2: fluids", "did you mean \"fluid\""}},
    {R"({"zzzzzzzz": {}})", {"zzzzzzzz", "accepted: name, fluid, domain"}},
    {"{\n \"fluid\": {\n  \"spacing\": 0\n }\n}",
     {"bad.json:3:3: fluid.spacing: 0 is out of range; accepted: 1e-06 ... 100 m"}},
    {R"({"fluid": {"spacing": "x"}})", {"expected a number", "found \"x\"", "100 m"}},
    {R"({"fluid": {"viscosity": -0.1}})", {"fluid.viscosity", "-0.1", "Pa·s"}},
    {R"({"fluid": 3})", {"fluid: expected an object", "spacing", "found 3"}},
    {R"({"fluid": {"volumes": {}}})", {"fluid.volumes: expected a list"}},
    {R"({"fluid": {"volumes": []}})", {"fluid.volumes: empty"}},
    {R"({"fluid": {"volumes": [{}]}})", {"fluid.volumes[0]", "box, sphere, cylinder", "found 0"}},
    {R"({"fluid": {"volumes": [{"box": {"min": [0,0,0]}}]}})",
     {"volumes[0].box", "\"max\" is missing"}},
    {R"({"fluid": {"volumes": [{"ball": {}}]}})", {"fluid.volumes[0].ball", "unknown key"}},
    {R"({"fluid": {"volumes": [{"box": {"min": [0,0,0], "max": [1,1]}}]}})",
     {"fluid.volumes[0].box.max", "three numbers [x, y, z]", "[1,1]"}},
    {R"({"fluid": {"volumes": [{"box": {"min": [0,0,0], "max": [1,"1",1]}}]}})",
     {"fluid.volumes[0].box.max[1]", "found \"1\""}},
    {R"({"solver": {"type": "pcsph"}})", {"solver.type", "\"pcsph\"", "did you mean \"pcisph\""}},
    {R"({"solver": {"type": "dfsph-x-y-z"}})", {"accepted: pcisph, sph"}},
    {R"({"solver": {"type": 1}})", {"expected one of pcisph, sph, found 1"}},
    {R"({"solver": {"min_iterations": 1.5}})", {"1.5 is not a whole number"}},
    {R"({"look": {"floor": 1}})", {"look.floor: expected true or false, found 1"}},
    {R"({"look": {"liquid_color": [0, 0.5, 1.2]}})", {"look.liquid_color[2]: 1.2", "0 ... 1"}},
    {R"({"name": 7})", {"name: expected text, found 7"}},
    {R"({"video": {"width": 100000}})", {"video.width", "16 ... 8192 pixels"}},
    {R"({"video": {"width": null}})", {"video.width", "found null"}},
    {R"([])", {"bad.json:1:1", "expected an object"}},
    {R"({"probes": [{"name": "p", "presure": {"point": [1,1,0.4]}}]})",
     {"bad.json:1:27: probes[0].presure", "did you mean \"pressure\""}},
    {R"({"probes": [{"name": "p"}]})",
     {"bad.json:1:13: probes[0]", "one quantity out of surface_height, pressure", "found 0"}},
    {R"({"probes": [{"name": "p", "energy": {}, "volume": {}}]})", {"probes[0]", "found 2"}},
    {R"({"probes": [{"energy": {}}]})", {"probes[0]", "\"name\" is missing"}},
    {R"({"probes": [{"name": "p", "surface_height": {"x": 1}}]})",
     {"probes[0].surface_height", "\"z\" is missing"}},
    {R"({"probes": [{"name": "p", "front": {"direction": "x"}}]})",
     {"probes[0].front.direction", "did you mean \"+x\""}},
    {R"({"probes": [{"name": "p", "energy": {"total": true}}]})",
     {"probes[0].energy.total: unknown key; none is accepted here, write {}"}},
    {R"({"probes": [{"name": "p", "energy": true}]})",
     {"probes[0].energy: expected an empty object {}, found true"}},
    {R"({"probes_rate": -1})", {"probes_rate: -1 is out of range", "1/s"}},
    {R"({"domain": {"open": ["up"]}})", {"domain.open[0]", "unknown value \"up\"", "+y"}},
    {R"({"domain": {"open": "+y"}})", {"domain.open: expected a list"}},
    {R"({"fluid": {"emitters": [{"speed": 1}]}})",
     {"fluid.emitters[0]", "one opening out of disc, rectangle", "found 0"}},
    {R"({"fluid": {"emitters": [{"disc": {"center": [1,1,0.4], "radius": 0.1}}]}})",
     {"emitters[0].disc", "\"direction\" is missing"}},
    {R"({"sinks": [{"bx": {}}]})", {"sinks[0].bx: unknown key", "did you mean \"box\""}},
};

const std::vector<Case> wrong_together{
    {R"({"name": "a/b"})", {"name", "can't name a folder"}},
    {R"({"domain": {"min": [0, 5, 0]}})", {"domain", "min [0, 5, 0] is not below max", "in y"}},
    {R"({"domain": {"max": [3, 2e4, 0.8]}})", {"domain", "20000 m from the origin in y", "100000"}},
    {R"({"domain": {"max": [3, 2, 0.05]}})", {"domain: 0.05 m wide in z", "4 particle spacings"}},
    {R"({"fluid": {"volumes": [{"box": {"min": [0,0,0], "max": [0.5,0,0.5]}}]}})",
     {"fluid.volumes[0].box", "in y"}},
    {R"({"fluid": {"volumes": [{"box": {"min": [0,0,0], "max": [1,1,0.81]}},
                               {"box": {"min": [3,0,0], "max": [4,1,0.8]}}]}})",
     {"bad.json:2:32: fluid.volumes[1]: 800 litres from [3, 0, 0] to [4, 1, 0.8]",
      "outside the domain [0, 0, 0] ... [3.2, 2, 0.8]"}},
    {R"({"fluid": {"volumes": [{"sphere": {"center": [0.1,1,0.4], "radius": 0.3}}]}})",
     {"fluid.volumes[0]", "outside the domain"}},
    {R"({"fluid": {"volumes": [{"box": {"min": [0,0,0], "max": [0.01,0.01,0.01]}}]}})",
     {"fluid.volumes[0]: holds no particle at a spacing of 0.025 m"}},
    {R"({"fluid": {"volumes": [{"sphere": {"center": [1,1,0.4], "radius": 0.1}}]},
         "obstacles": [{"box": {"min": [0.8,0.8,0.2], "max": [1.2,1.2,0.6]}}]})",
     {"fluid.volumes[0]: all of its 4.19 litres are inside obstacles[0]"}},
    {R"({"fluid": {"volumes": [{"box": {"min": [0,0,0], "max": [1e5,0.4,2]}}]}})",
     {"fluid.volumes[0]: 8e+07 litres", "outside the domain"}},
    {R"({"domain": {"max": [2000,2000,2000]}, "fluid": {"volumes": [{"box": {"min": [0,0,0], "max": [2000,2000,2000]}}]}})",
     {"fluid.spacing", "5.1e+14 particles; at most 2e+08"}},
    {R"({"domain": {"max": [2000,2000,2000]}})",
     {"fluid.spacing", "particles on walls and obstacles; at most 2e+08"}},
    {R"({"fluid": {"spacing": 4e-5}})", {"fluid.spacing", "particles; at most 2e+08"}},
    {R"({"obstacles": [{"cylinder": {"from": [1,1,1], "to": [1,1,1], "radius": 1}}]})",
     {"obstacles[0].cylinder", "same point"}},
    {R"({"obstacles": [{"capsule": {"from": [1,1,1], "to": [1,1,1], "radius": 1}}]})",
     {"obstacles[0].capsule", "same point"}},
    {R"({"obstacles": [{"capsule": {"from": [1,1,1], "to": [2,1,1]}}]})",
     {"obstacles[0].capsule", "\"radius\" is missing"}},
    {R"({"obstacles": [{"capsul": {}}]})", {"obstacles[0].capsul", "did you mean \"capsule\""}},
    {R"({"obstacles": [{"box": {"min": [0,0,0], "max": [1,1,1]}, "motion": {}}]})",
     {"bad.json:1:58: obstacles[0].motion: says nothing", "keyframes, oscillations or spin"}},
    {R"({"obstacles": [{"box": {"min": [0,0,0], "max": [1,1,1]}, "motion": {"keyframes": [
         {"time": 1}, {"time": 0.5, "translate": [1,0,0]}]}}]})",
     {"bad.json:2:24: obstacles[0].motion.keyframes[1].time: 0.5 s is not after", "(1 s)"}},
    {R"({"obstacles": [{"box": {"min": [0,0,0], "max": [1,1,1]}, "motion": {
         "oscillations": [{"frequency": 2}]}}]})",
     {"motion.oscillations[0]: has no amplitude", "translate (m) or rotate (degrees)"}},
    {R"({"obstacles": [{"box": {"min": [0,0,0], "max": [1,1,1]}, "motion": {
         "spin": {"axis": [0,0,0], "frequency": 2}}}]})",
     {"obstacles[0].motion.spin.axis: has no length"}},
    {R"({"obstacles": [{"box": {"min": [0,0,0], "max": [1,1,1]}, "motion": {
         "spin": {"axis": [0,0,1]}}}]})",
     {"obstacles[0].motion.spin: \"frequency\" is missing"}},
    {R"({"obstacles": [{"box": {"min": [0,0,0], "max": [1,1,1]}, "motion": {"spinn": {}}}]})",
     {"obstacles[0].motion.spinn", "did you mean \"spin\""}},
    {R"({"obstacles": [{"box": {"min": [0,0,0], "max": [1,1,1]}, "motion": {
         "interpolation": "cubic", "keyframes": [{"time": 0}]}}]})",
     {"motion.interpolation", "smooth, linear"}},
    {R"({"obstacles": [{"box": {"min": [0,0,0], "max": [1,1,1]}, "wall_viscosity": -1}]})",
     {"obstacles[0].wall_viscosity: -1 is out of range", "Pa·s"}},
    {R"({"video": {"width": 641}})", {"video.width: 641 is odd"}},
    {R"({"video": {"height": 361}})", {"video.height: 361 is odd"}},
    {R"({"video": {"duration": 0.001}})", {"video.duration", "frames"}},
    {R"({"solver": {"min_iterations": 70}})", {"solver.min_iterations: 70 is above", "60"}},
    {R"({"solver": {"min_time_step": 0.5}})", {"solver.min_time_step", "max_time_step (0.005 s)"}},
    {R"({"forces": {"body": [{"time": 1, "acceleration": [0,0,0]},
                             {"time": 1, "acceleration": [0,0,0]}]}})",
     {"bad.json:2:31: forces.body[1].time: 1 s is not after"}},
    {R"({"camera": {"position": [0,0,1], "target": [0,0,1]}})", {"camera", "same point"}},
    {R"({"camera": {"position": [0,5,0], "target": [0,0,0]}})",
     {"camera", "up [0, 1, 0] is along"}},
    {R"({"camera": {"position": [0,5,0]}})", {"camera", "\"target\" is missing"}},
    {R"({"camera": {"keyframes": [], "position": [0,0,1]}})",
     {"either keyframes or a still camera"}},
    {R"({"camera": {"keyframe": []}})", {"did you mean \"keyframes\""}},
    {R"({"light": {"direction": [0,0,0]}})", {"light.direction", "no length"}},
    {R"({"probes": [{"name": "a,b", "energy": {}}]})",
     {"probes[0].name: \"a,b\" can't name a column", "letters, digits, _ and -"}},
    {R"({"probes": [{"name": "", "energy": {}}]})", {"probes[0].name", "can't name a column"}},
    {R"({"probes": [{"name": "a", "energy": {}}, {"name": "a", "volume": {}}]})",
     {"bad.json:1:43: probes[1].name: \"a\" is the name of probes[0] already"}},
    {R"({"probes": [{"name": "a", "surface_height": {"x": 1, "z": 0.9}}]})",
     {"probes[0].surface_height: z = 0.9 m is outside the domain [0, 0, 0] ... [3.2, 2, 0.8]"}},
    {R"({"probes": [{"name": "a", "pressure": {"point": [1, -0.1, 0.4]}}]})",
     {"probes[0].pressure.point: y = -0.1 m is outside the domain"}},
    {R"({"probes": [{"name": "a", "energy": {}}], "probes_rate": 1e6})",
     {"probes_rate", "4e+06", "1000000"}},
    {R"({"look": {"color_min": 5, "color_max": 1}})", {"look.color_min", "above color_max"}},
    {R"({"fluid": {"emitters": [{"disc": {"center": [1,1,0.4], "direction": [0,0,0], "radius": 0.1}}]}})",
     {"fluid.emitters[0].disc.direction: has no length"}},
    {R"({"fluid": {"emitters": [{"disc": {"center": [1,1,0.4], "direction": [0,0,0], "radius": 0.1}},
                                {"disc": {"center": [1,1,0.4], "direction": [0,-1,0], "radius": 0.1}, "from": 2, "to": 1}]},
         "domain": {"open": ["+x", "+x"]}})",
     {"fluid.emitters[0].disc.direction: has no length", "fluid.emitters[1].to: 1 s is not after",
      "domain.open[1]: \"+x\" stands there already"}},
    {R"({"obstacles": [{"mesh": {"file": "none.obj"}}, {"mesh": {"file": "no.ply"}}]})",
     {"obstacles[0].mesh.file: ", "obstacles[1].mesh.file: "}},
    {R"({"fluid": {"emitters": [{"disc": {"center": [1,1,0.4], "direction": [0,1,0], "radius": 0.02}}]}})",
     {"disc.radius: the opening is 0.04 m wide", "2 particle spacings (0.05 m)"}},
    {R"({"fluid": {"emitters": [{"disc": {"center": [1,0,0.4], "direction": [0,-1,0], "radius": 0.1}}]}})",
     {"emitters[0].disc: the particle that comes out at",
      "outside the domain [0, 0, 0] ... [3.2, 2, 0.8]"}},
    {R"({"fluid": {"emitters": [{"disc": {"center": [1,1,0.4], "direction": [0,-1,0], "radius": 0.1}, "from": 2, "to": 1}]}})",
     {"emitters[0].to: 1 s is not after from (2 s)"}},
    {R"({"fluid": {"emitters": [{"disc": {"center": [1,1,0.4], "direction": [0,-1,0], "radius": 0.1}, "max_particles": 5}]}})",
     {"emitters[0].max_particles: 5 is less than the", "of one layer"}},
    {R"({"fluid": {"emitters": [{"disc": {"center": [1,1,0.4], "direction": [0,-1,0], "radius": 0.1}, "to": 0.01}]}})",
     {"emitters[0].to", "nothing comes out"}},
    {R"({"fluid": {"emitters": [{"rectangle": {"center": [1,1,0.4], "direction": [0,-1,0], "width": 0.1, "height": 0.1}}]}})",
     {"emitters[0].rectangle.up: [0, 1, 0] is along the direction [0, -1, 0]"}},
    {R"({"obstacles": [{"sphere": {"center": [1,1,0.4], "radius": 0.2}}], "fluid": {"emitters": [{"disc": {"center": [1,1,0.4], "direction": [0,-1,0], "radius": 0.1}}]}})",
     {"emitters[0].disc: the particle that comes out at", "inside obstacles[0]"}},
    {R"({"obstacles": [{"box": {"min": [0.5,1.5,0.2], "max": [1.5,1.6,0.6]}, "motion": {"keyframes": [{"time": 1}, {"time": 2, "translate": [0,-0.5,0]}]}}], "fluid": {"emitters": [{"disc": {"center": [1,1,0.4], "direction": [0,-1,0], "radius": 0.1}}]}})",
     {"emitters[0].disc: obstacles[0], which moves, is in the nozzle", "at 1.7"}},
    {R"({"video": {"duration": 20}, "fluid": {"emitters": [{"disc": {"center": [1,1,0.4], "direction": [0,-1,0], "radius": 0.3}, "speed": 1000}]}})",
     {"fluid.spacing", "at most 2e+08"}},
    {R"({"domain": {"open": ["+y", "-x", "+y"]}})",
     {"bad.json:1:34: domain.open[2]: \"+y\" stands there already"}},
    {R"({"sinks": [{"box": {"min": [0,0,0], "max": [1,0,1]}}]})", {"sinks[0].box: min", "in y"}},
};

const std::vector<Case> not_json{
    {"", {"bad.json:1:1"}},
    {"{\"fluid\": {\"spacing\": 0.1,}}", {"bad.json:1:27: not valid JSON: unexpected"}},
    {"{\n  \"fluid\": {}\n  \"domain\": {}\n}", {"bad.json:3:10: not valid JSON"}},
    {"{\"fluid\": {}, \"fluid\": {}}",
     {"bad.json:1:15: \"fluid\" is given twice", "line 1, column 2"}},
    {"{\"fluid\": {\"spacing\": 1e999}}", {"bad.json:1:23: 1e999 is too large"}},
    {"{} {}", {"bad.json:1:4"}},
};

void check_all(const std::vector<Case>& cases) {
  for (const Case& one : cases) {
    const std::string message = complaint(one.text);
    INFO(one.text);
    INFO(message);
    CHECK(message != "");
    for (const std::string& fragment : one.fragments) {
      INFO(fragment);
      CHECK(message.find(fragment) != std::string::npos);
    }
  }
}

}  // namespace

TEST_CASE("a wrong key, type or value is named with its place and what is accepted") {
  check_all(wrong_values);
}

TEST_CASE("values that do not fit together are refused with their place") {
  check_all(wrong_together);
}

TEST_CASE("text that is not JSON is refused with line and column") {
  check_all(not_json);
}

TEST_CASE("all unknown keys and wrong values are told at once, in the order of the file") {
  CHECK(complaint(
            "{\n"
            "  \"video\": {\"width\": \"x\", \"quality\": 18},\n"
            "  \"fluid\": {\"spacing\": -1, \"viscosty\": 1, \"volumes\": [{\"sphere\": {}}]},\n"
            "  \"look\": {\"stile\": \"mesh\"}\n}") ==
        "bad.json:2:13: video.width: expected a number (16 ... 8192 pixels), found \"x\"\n"
        "bad.json:3:13: fluid.spacing: -1 is out of range; accepted: 1e-06 ... 100 m\n"
        "bad.json:3:28: fluid.viscosty: unknown key; did you mean \"viscosity\"?\n"
        "bad.json:3:56: fluid.volumes[0].sphere: \"center\" is missing (centre)\n"
        "bad.json:3:56: fluid.volumes[0].sphere: \"radius\" is missing (radius)\n"
        "bad.json:4:12: look.stile: unknown key; did you mean \"style\"?");
}

TEST_CASE("all values that do not fit together are told at once") {
  CHECK(complaint(R"({"name": "a/b", "video": {"width": 641, "height": 361},
    "solver": {"min_iterations": 70}, "domain": {"min": [0, 5, 0]}})") ==
        "bad.json:1:2: name: \"a/b\" can't name a folder\n"
        "bad.json:1:27: video.width: 641 is odd; accepted: even numbers\n"
        "bad.json:1:41: video.height: 361 is odd; accepted: even numbers\n"
        "bad.json:2:16: solver.min_iterations: 70 is above max_iterations (60)\n"
        "bad.json:2:39: domain: min [0, 5, 0] is not below max [3.2, 2, 0.8] in y");
}

TEST_CASE("a mistyped key is not found missing as well") {
  CHECK(complaint(R"({"obstacles": [{"sphere": {"center": [1,1,0.4], "radus": 0.1}}]})") ==
        "bad.json:1:49: obstacles[0].sphere.radus: unknown key; did you mean \"radius\"?");
  CHECK(complaint(R"({"obstacles": [{"spere": {"center": [1,1,0.4], "radius": 0.1}}]})") ==
        "bad.json:1:17: obstacles[0].spere: unknown key; did you mean \"sphere\"?");
}

TEST_CASE("of very many problems twenty are told and the rest counted") {
  std::string text = "{";
  for (int k = 0; k < 5'000; ++k)
    text += "\"unknown_key_" + std::to_string(k) + "\": 0, ";
  const std::string message = complaint(text + "\"name\": 7}");
  CHECK(std::count(message.begin(), message.end(), '\n') == 20);
  CHECK(message.find("\nbad.json:1:") != message.npos);
  CHECK(message.ends_with("\nand 4981 more"));
}

TEST_CASE("a frame rate is a number or a fraction") {
  check_all(
      {{R"({"video": {"frames_per_second": "fast"}})",
        {"bad.json:1:12: video.frames_per_second: \"fast\" is no frame rate", "30000/1001",
         "1 ... 1000 1/s"}},
       {R"({"video": {"frames_per_second": "30/0"}})", {"\"30/0\" is no frame rate"}},
       {R"({"video": {"frames_per_second": "-30/-1"}})", {"is no frame rate"}},
       {R"({"video": {"frames_per_second": "30/1x"}})", {"is no frame rate"}},
       {R"({"video": {"frames_per_second": "99999999999999999999/1"}})", {"is no frame rate"}},
       {R"({"video": {"frames_per_second": 29.97002997}})", {"29.97002997 is no frame rate"}},
       {R"({"video": {"frames_per_second": "2001/2"}})", {"\"2001/2\" is out of range"}},
       {R"({"video": {"frames_per_second": "1001/30000"}})",
        {"is out of range; accepted: 1 ... 1000"}},
       {R"({"video": {"frames_per_second": 0.5}})", {"0.5 is out of range"}},
       {R"({"video": {"frames_per_second": true}})", {"expected a number", "found true"}}});
}

}  // namespace app_scene_errors_tests
