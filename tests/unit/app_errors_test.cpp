// Limits of what is read, text of any kind in messages, and names that are nearly right.
#include <algorithm>
#include <catch2/catch.hpp>
#include <chrono>
#include <string>
#include <vector>

#include "app/errors/nearest_name.hpp"
#include "app/errors/shown_text.hpp"
#include "scene_errors_support.hpp"

namespace app_errors_tests {

using namespace spindrift::app;

TEST_CASE("nesting has a limit, told with its place") {
  const auto nested = [](int levels, const std::string& inner) {
    return std::string(static_cast<std::size_t>(levels), '[') + inner +
           std::string(static_cast<std::size_t>(levels), ']');
  };
  const std::string refused =
      "nested too deep; at most 64 levels of lists and objects are accepted";
  CHECK(complaint("{\"fluid\": " + nested(100'000, "") + "}") == "bad.json:1:74: " + refused);
  CHECK(complaint("{\"fluid\": " + std::string(100'000, '[')) == "bad.json:1:74: " + refused);
  CHECK(complaint("{\"fluid\": " + nested(64, "") + "}") == "bad.json:1:74: " + refused);
  CHECK(complaint("{\"fluid\":\n" + nested(63, "") + "}")
            .starts_with("bad.json:1:2: fluid: expected"));
  CHECK(complaint("{}", {"fluid=" + nested(50'000, "")}).ends_with(refused));
  std::string deep_key = "fluid";
  for (int k = 0; k < 30'000; ++k)
    deep_key += ".a";
  CHECK(complaint("{}", {deep_key + "=1"})
            .ends_with("nested too deep; at most 64 levels are accepted"));
}

TEST_CASE("a scene is read in time proportional to its length") {
  const auto start = std::chrono::steady_clock::now();
  std::string zeros = "0", obstacles, keys;
  for (int k = 0; k < 200'000; ++k)
    zeros += ",0";
  for (int k = 0; k < 50'000; ++k)
    obstacles += R"({"sphere": {"center": [1, 1, 0.4], "radius": 0.001}}, )";
  for (int k = 0; k < 50'000; ++k)
    keys += "\"key" + std::to_string(k) + "\": 1, ";
  CHECK(complaint("{\"fluid\": [" + zeros + "]}").starts_with("bad.json:1:2: fluid: expected"));
  CHECK(complaint("{\"obstacles\": [" + obstacles + "{}]}").starts_with("bad.json:1:2700016: "));
  CHECK(complaint("{\"fluid\": {" + keys + "\"key0\": 1}}").find("\"key0\" is given twice") !=
        std::string::npos);
  const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
  CHECK(spent.count() < 30);  // a second; minutes where places are counted from the start each time
}

TEST_CASE("a number beyond a double's range is refused with its place") {
  const std::string too_large =
      "1e309 is too large for a number; at most about 1.8e308 is accepted";
  CHECK(complaint("{\"fluid\":\n {\"spacing\": /* m */ 1e309}}") == "bad.json:2:22: " + too_large);
  CHECK(complaint("{}", {"fluid.spacing=1e309"}) == "--set fluid.spacing=1e309: " + too_large);
  CHECK(
      complaint("{\"domain\": {\"max\": [1, -1e400, 1]}}").starts_with("bad.json:1:24: -1e400 is"));
}

TEST_CASE("text that is no clean UTF-8 is read or refused in words") {
  CHECK(complaint("\xef\xbb\xbf{\"fluid\": {\"viscosity\": 0.1}}").empty());  // a byte order mark
  CHECK(complaint("\xef\xbb\xbf{\"fluids\": {}}").starts_with("bad.json:1:2: fluids"));
  CHECK(complaint("{\"a\xff\": 1}").starts_with("bad.json:1:4: not valid JSON: invalid string"));
  CHECK(complaint("{\"\u00e9\u00e9\": {}, \"fluids\": {}}").find("bad.json:1:12: fluids") !=
        std::string::npos);
  CHECK(complaint(std::string("{}\0", 3)).starts_with("bad.json:1:3: not valid JSON: a NUL"));
  CHECK(complaint(std::string("{ // \0\n}", 8)).starts_with("bad.json:1:6: not valid JSON: a NUL"));
  CHECK(complaint("\xff\xfe{").starts_with("bad.json:1:1: not valid JSON"));
}

TEST_CASE("volumes are told in litres, without exponents up to a thousand cubic metres") {
  CHECK(litres_text(4.188e-3) == "4.19");
  CHECK(litres_text(0.9994) == "999");
  CHECK(litres_text(0.9996) == "1000");
  CHECK(litres_text(9.004) == "9000");
  CHECK(litres_text(123.4567) == "123000");
}

TEST_CASE("long and hostile text is shortened and escaped in messages") {
  const std::string huge(100'000, 'x');
  for (const std::string& text :
       {"{\"" + huge + "\": 1}", "{\"look\": {\"style\": \"" + huge + "\"}}",
        "{\"name\": \"" + huge + "\"}", "{\"fluid\": " + huge + "}",
        "{\"fluid\": [\"" + huge + "\"]}",
        "{\"probes\": [{\"name\": \"" + huge + "?\", \"energy\": {}}]}"}) {
    const std::string message = complaint(text);
    INFO(message.substr(0, 400));
    CHECK(message.size() > 10);
    CHECK(message.size() < 500);
  }
  CHECK(complaint("{}", {"fluid.spacing=\"" + huge + "\""}).size() < 500);
  for (const std::string text :
       {R"({"a\n\u001b[31m\u202e": 1})", R"({"name": "a\n\u001b[31m\u202e"})",
        R"({"look": {"style": "\n\u001b[31m\u202e"}})"}) {
    const std::string message = complaint(text);
    INFO(message);
    CHECK(message.find_first_of("\n\x1b") == std::string::npos);
    CHECK(message.find("\xe2\x80\xae") == std::string::npos);
    CHECK(message.find("\\u001b[31m\\u202e") != std::string::npos);
  }
  CHECK(escaped("a\x80\xc3\xa9\x7f\t") == "a\\x80\xc3\xa9\\u007f\\t");
  CHECK(shown("0123456789", 10) == "0123456789");
  CHECK(shown("01234567890", 10) == "0123456...");
  CHECK(shown("\xc3\xa9\xc3\xa9\xc3\xa9\xc3\xa9\xc3\xa9\xc3\xa9", 5) == "\xc3\xa9\xc3\xa9...");
}

TEST_CASE("what can't name a folder is refused, also where the file's name is taken") {
  const auto named = [](const std::string& file) -> std::string {
    try {
      parse_scene("{}", file);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(named("good.json").empty());
  CHECK(named("a\nb.json")
            .find("\"a\\nb\", the file's name, can't name a folder: it holds control "
                  "characters; give a \"name\"") != std::string::npos);
  CHECK(named(std::string(201, 'a') + ".json").find("it has 201 bytes; accepted: at most 200") !=
        std::string::npos);
  CHECK(complaint(R"({"name": "a\u0000b"})").find("\"a\\u0000b\" holds control characters") !=
        std::string::npos);
  CHECK(complaint("{\"name\": \"" + std::string(300, 'a') + "\"}").find("it has 300 bytes") !=
        std::string::npos);
  CHECK(complaint("{\"name\": \"" + std::string(200, 'a') + "\"}").empty());
}

TEST_CASE("every beginning of a scene file is refused or read, never a crash") {
  const std::string whole = R"({"fluid": {"spacing": 0.05, "volumes": [ /* c */
    {"box": {"min": [0, 0, 0], "max": [1, 1, 0.8]}, "velocity": [0, -1e0, 0]}]}, "name": "a\"b\u00e9"})";
  for (std::size_t length = 0; length < whole.size(); ++length) {
    INFO(whole.substr(0, length));
    CHECK(complaint(whole.substr(0, length)) != "");
  }
  CHECK(complaint(whole) == "");
}

TEST_CASE("an error that --set brings is blamed on it") {
  const auto begins = [](const std::string& message, const std::string& beginning) {
    INFO(message);
    CHECK(message.substr(0, beginning.size()) == beginning);
  };
  begins(complaint("{}", {"fluid.spacng=1"}), "--set fluid.spacng=1: fluid.spacng: unknown key");
  begins(complaint("{}", {"fluid.spacing=abc"}),
         "--set fluid.spacing=abc: fluid.spacing: expected");
  begins(complaint("{}", {"fluid.spacing"}), "--set fluid.spacing: expected KEY=VALUE");
  begins(complaint("{}", {"=1"}), "--set =1: expected KEY=VALUE");
  begins(complaint("{}", {" =1"}), "--set  =1: expected KEY=VALUE");
  begins(complaint("{}", {"viscosity=1"}),
         "--set viscosity=1: viscosity: unknown key; did you mean \"fluid.viscosity\"?");
  CHECK(complaint("{}", {" fluid.viscosity = 1", "look.style = particles "}).empty());
  begins(complaint("{}", {"fluid..spacing=1"}), "--set fluid..spacing=1: a name is missing");
  begins(complaint("{}", {"fluid.volumes[4].velocity=1"}),
         "--set fluid.volumes[4].velocity=1: fluid.volumes has 1 entries");
  begins(complaint("{}", {"fluid.volumes.first=1"}),
         "--set fluid.volumes.first=1: fluid.volumes is a list");
  begins(complaint(R"({"name": "a"})", {"name.x=1"}), "--set name.x=1: name is a single value");
  begins(complaint("{}", {"fluid.volumes[0].box.max=[9,1,1]"}),
         "--set fluid.volumes[0].box.max=[9,1,1]: fluid.volumes[0]: 9000 litres from");
  begins(complaint(R"({"fluid": {"spacing": 0}})", {"domain.max=[4,4,4]"}), "bad.json:1:12: ");
}

TEST_CASE("edit distance counts inserted, lost, replaced and swapped letters") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("abc", "abc") == 0);
  CHECK(edit_distance("abc", "") == 3);
  CHECK(edit_distance("spacng", "spacing") == 1);
  CHECK(edit_distance("spaicng", "spacing") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);
  CHECK(edit_distance("sitting", "kitten") == 3);
}

}  // namespace app_errors_tests
