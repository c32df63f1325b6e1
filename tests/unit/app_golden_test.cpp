// What the author of a list of golden tests is told when something is wrong with it.
#include <catch2/catch.hpp>

#include "app/golden/golden_list.hpp"
#include "output_support.hpp"

namespace app_golden_tests {

using namespace spindrift::app;
using spindrift::output_test::TemporaryFolder;

namespace {

class Lists {
 public:
  Lists() {
    std::ofstream(folder_ / "drop.json") << R"({"video": {"duration": 0.3}})";
    std::ofstream(folder_ / "bad.json") << R"({"fluid": {"spacng": 1}})";
  }

  GoldenList read(const std::string& text, const Overrides& overrides = {}) const {
    std::ofstream(folder_ / "list.json") << text;
    return read_golden_list(folder_ / "list.json", overrides);
  }

  std::string complaint(const std::string& text) const {
    try {
      read(text);
    } catch (const SceneError& error) {
      std::string message = error.what();  // without the folder
      const std::string folder = folder_ / "";
      for (auto at = message.find(folder); at != message.npos; at = message.find(folder))
        message.erase(at, folder.size());
      return message;
    }
    return "";
  }

 private:
  TemporaryFolder folder_;
};

}  // namespace

TEST_CASE("a list gives every golden test its name, its scene and its size") {
  const Lists lists;
  const GoldenList list = lists.read(
      R"({"width": 64, "height": 36, "max_flip": 0.1, "goldens": [
          {"scene": "drop.json", "frames": [8, 0]},
          {"scene": "drop.json", "frames": [1], "name": "thick", "set": ["fluid.viscosity=3"],
           "width": 32, "max_changed": 0.5}]})",
      {"light.intensity=0.25"});
  REQUIRE(list.goldens.size() == 2);
  const Golden &first = list.goldens[0], &second = list.goldens[1];
  CHECK(first.name == "drop");
  CHECK(first.frames == std::vector{0, 8});
  CHECK(first.resolved.video.width == 64);
  CHECK(first.resolved.light.intensity == 0.25f);
  CHECK(second.name == "thick");
  CHECK((second.resolved.video.width == 32 && second.resolved.video.height == 36));
  CHECK(second.resolved.simulation.fluid.viscosity == 3);
  CHECK((list.max_flip == 0.1 && second.max_changed == 0.5 && !second.max_flip));
}

TEST_CASE("a wrong list is refused with the place and what is accepted") {
  const Lists lists;
  const auto with = [](const std::string& golden) { return R"({"goldens": [)" + golden + "]}"; };
  const std::vector<std::pair<std::string, std::vector<std::string>>> cases{
      {R"({"golden": []})", {"list.json:1:2: golden: unknown key; did you mean \"goldens\"?"}},
      {R"({})", {"\"goldens\" is missing"}},
      {R"({"goldens": []})",
       {"list.json:1:2: goldens: expected a list [...] of at least one entry"}},
      {R"({"max_flip": 2, "goldens": []})",
       {"max_flip: 2 is out of range; accepted: 0 ... 1", "goldens: expected a list"}},
      {with(R"({"scene": "drop.json"})"), {"goldens[0]: \"frames\" is missing"}},
      {with(R"({"scene": "drop.json", "frames": []})"),
       {"goldens[0].frames: expected a list [...] of at least one entry"}},
      {with(R"({"scene": "drop.json", "frames": [1.5]})"),
       {"goldens[0].frames[0]: 1.5 is not a whole number; accepted: 0 ... 1"}},
      {with(R"({"scene": "drop.json", "frames": [2, 9]})"),
       {"list.json:1:37: goldens[0].frames: 9 is beyond the scene's last frame, 8"}},
      {with(R"({"scene": "drip.json", "frames": [0]})"),
       {"goldens[0].scene: ", "drip.json: there is no such file"}},
      {with(R"({"scene": "bad.json", "frames": [0]})"),
       {"goldens[0].scene: ", "bad.json:1:12: fluid.spacng", "did you mean \"spacing\"?"}},
      {with(R"({"scene": "drop.json", "frames": [0], "set": ["fluid.spacng=1"]})"),
       {"list.json:1:60: goldens[0].set[0]: fluid.spacng: unknown key"}},
      {with(R"({"scene": "drop.json", "frames": [0], "width": 33})"),
       {"list.json:1:52: goldens[0].width: video.width: 33 is odd"}},
      {R"({"height": 17, "goldens": [{"scene": "drop.json", "frames": [0]}]})",
       {"list.json:1:2: height: video.height: 17 is odd"}},
      {with(R"({"scene": "drop.json", "frames": [2, 1, 2]})"),
       {"goldens[0].frames: 2 is there twice"}},
      {with(R"({"scene": "drop.json", "frames": [0], "name": "../a"})"),
       {"goldens[0].name: \"../a\" can't name a folder; accepted: letters"}},
      {with(R"({"scene": "drop.json", "frames": [0]}, {"scene": "drop.json", "frames": [1]})"),
       {"goldens[1].name: \"drop\" is the name of goldens[0] already"}},
  };
  for (const auto& [text, fragments] : cases) {
    const std::string message = lists.complaint(text);
    INFO(text);
    INFO(message);
    for (const std::string& fragment : fragments)
      CHECK(message.find(fragment) != std::string::npos);
  }
}

TEST_CASE("all that is wrong with a list is told at once") {
  const Lists lists;
  CHECK(
      lists.complaint(R"({"max_flip": 2, "goldens": [{"frames": [1.5], "hight": 3}]})") ==
      "list.json:1:2: max_flip: 2 is out of range; accepted: 0 ... 1\n"
      "list.json:1:29: goldens[0]: \"scene\" is missing (the scene file, from the list's folder)\n"
      "list.json:1:41: goldens[0].frames[0]: 1.5 is not a whole number; accepted: 0 ... 1000000\n"
      "list.json:1:47: goldens[0].hight: unknown key; did you mean \"height\"?");
  const std::string message = lists.complaint(
      R"({"goldens": [{"scene": "drop.json", "frames": [9], "name": "../a"},
                      {"scene": "bad.json", "frames": [0], "set": ["fluid.spacing=0", "look.stile=1"]}]})");
  INFO(message);
  for (const char* part : {"goldens[0].name: \"../a\" can't name", "goldens[0].frames: 9 is beyond",
                           "goldens[1].scene: ", "bad.json:1:12: fluid.spacng: unknown key",
                           "goldens[1].set[0]: fluid.spacing: 0 is out of range",
                           "goldens[1].set[1]: look.stile: unknown key"})
    CHECK(message.find(part) != message.npos);
}

}  // namespace app_golden_tests
