// One early frame of every scene that ships, from the scene file to the PNG, against
// tests/golden/scenes. The list is scenes.json. A liquid is chaotic, so the frames are early and
// the tolerance is looser than the renderer's own. Set SPINDRIFT_UPDATE_GOLDENS=1 to write the
// pictures anew.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <set>

#include "app/commands.hpp"
#include "app/scene.hpp"
#include "render/output/output.hpp"

namespace fs = std::filesystem;
using namespace spindrift;

namespace {

/// Of 255, in any channel: a pixel that is off by more differs.
constexpr int tolerance = 16;
/// Share of the pixels that may differ.
constexpr double share_allowed = 0.01;

const fs::path source = SOURCE_DIR;
const fs::path results = fs::path(RESULT_DIR) / "golden_scenes";

struct Difference {
  double share = 1;  ///< of the pixels beyond the tolerance
  Image picture;     ///< the difference, eightfold
};

Difference difference(const Image& a, const Image& b) {
  Difference d;
  if (a.width != b.width || a.height != b.height)
    return d;
  d.picture = Image(a.width, a.height);
  std::size_t off = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 3) {
    int largest = 0;
    for (std::size_t c = i; c < i + 3; ++c) {
      const int delta = std::abs(int{a.pixels[c]} - int{b.pixels[c]});
      largest = std::max(largest, delta);
      d.picture.pixels[c] = static_cast<std::uint8_t>(std::min(255, 8 * delta));
    }
    off += largest > tolerance;
  }
  d.share = static_cast<double>(off) / (static_cast<double>(a.pixels.size()) / 3);
  return d;
}

/// Renders one frame of a scene at a small size, as the command does, and returns the PNG's pixels.
Image render(const std::string& scene_name, const std::string& name, int frame,
             app::Overrides set) {
  for (const char* size : {"video.width=320", "video.height=180"})
    set.push_back(size);
  const app::Scene scene = app::read_scene(source / "scenes" / (scene_name + ".json"), set);
  app::RenderOptions options;
  options.output = results / name;
  options.frames = app::FrameRange{frame, frame};
  options.cache = false;
  options.quiet = true;
  REQUIRE(app::run_render(scene, options) == app::done);
  return output::read_png(options.output / "frames" / fmt::format("{:04}.png", frame));
}

void check(const nlohmann::json& entry) {
  const std::string scene = entry.at("scene");
  const std::string name = entry.value("name", scene);
  const Image image = render(scene, name, entry.at("frame"), entry.value("set", app::Overrides{}));
  const fs::path golden_file = source / "tests/golden/scenes" / (name + ".png");
  if (std::getenv("SPINDRIFT_UPDATE_GOLDENS")) {
    fs::create_directories(golden_file.parent_path());
    output::write_png(golden_file, image);
    return;
  }
  INFO("the picture, its golden and their difference are in " << (results / name).string());
  REQUIRE(fs::exists(golden_file));
  const Image golden = output::read_png(golden_file);
  const Difference d = difference(image, golden);
  if (d.share > share_allowed) {
    fs::copy_file(golden_file, results / name / "golden.png", fs::copy_options::overwrite_existing);
    if (d.picture.width > 0)
      output::write_png(results / name / "difference.png", d.picture);
  }
  CHECK(d.share <= share_allowed);
}

nlohmann::json entries() {
  std::ifstream in(source / "tests/golden/scenes.json");
  return nlohmann::json::parse(in);
}

}  // namespace

TEST_CASE("every shipped scene has a golden frame") {
  std::set<std::string> listed;
  for (const auto& entry : entries())
    listed.insert(entry.at("scene").get<std::string>());
  for (const auto& file : fs::directory_iterator(source / "scenes")) {
    const std::string name = file.path().filename().string();
    if (name.ends_with(".json") && name != "scene.schema.json")
      CHECK(listed.count(file.path().stem().string()) == 1);
  }
}

TEST_CASE("a frame of the dam break is the golden one", "[slow]") {
  check(entries().at(0));
}
TEST_CASE("a frame of the dam break as particles is the golden one", "[slow]") {
  check(entries().at(1));
}
TEST_CASE("a frame of the double dam break is the golden one", "[slow]") {
  check(entries().at(2));
}
TEST_CASE("a frame of the two dropping blocks is the golden one", "[slow]") {
  check(entries().at(3));
}
TEST_CASE("a frame of the tank at rest is the golden one", "[slow]") {
  check(entries().at(4));
}
TEST_CASE("a frame of the dropping ball is the golden one", "[slow]") {
  check(entries().at(5));
}
TEST_CASE("a frame of the sheet on the knot is the golden one", "[slow]") {
  check(entries().at(6));
}
TEST_CASE("a frame of the mixer is the golden one", "[slow]") {
  check(entries().at(7));
}
TEST_CASE("a frame of the wave maker is the golden one", "[slow]") {
  check(entries().at(8));
}

TEST_CASE("a frame of the fountain is the golden one", "[slow]") {
  check(entries().at(7));
}

TEST_CASE("a frame of the weightless drops is the golden one", "[slow]") {
  check(entries().at(7));
}

TEST_CASE("a moved light, a missing obstacle and a weaker gravity are seen", "[slow]") {
  const fs::path golden_file = source / "tests/golden/scenes/dam_break.png";
  REQUIRE(fs::exists(golden_file));
  const Image golden = output::read_png(golden_file);
  for (const char* change :
       {"light.direction=[0.6,-1,0.3]", "obstacles=[]", "forces.gravity=[0,-8.8,0]"}) {
    CAPTURE(change);
    const Image image =
        render("dam_break", "planted_change", entries().at(0).at("frame"), {change});
    CHECK(difference(image, golden).share > share_allowed);
  }
}
