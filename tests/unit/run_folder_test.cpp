// A run's folder holds the files of one scene, and run.json says of which, whatever was run in it
// before.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <filesystem>
#include <iterator>
#include <set>

#include "pipeline_support.hpp"

namespace {

constexpr const char* green = "look.liquid_color=[0.2,0.7,0.3]";

/// Files of a run, less the particles and what times depend on.
std::set<std::string> files_in(const fs::path& folder) {
  std::set<std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    const std::string name = fs::relative(entry.path(), folder).string();
    if (entry.is_regular_file() && !name.starts_with("particles/") && !name.starts_with("."))
      files.insert(name);
  }
  return files;
}

void require_same_pictures(const fs::path& a, const fs::path& b) {
  for (const auto& entry : fs::directory_iterator(a / "frames"))
    CHECK(bytes_of(entry.path()) == bytes_of(b / "frames" / entry.path().filename()));
}

void cut_short(const fs::path& run, int number) {
  const fs::path kept = fs::directory_iterator(run / "particles")->path();
  fs::resize_file(kept / fmt::format("{:04}.particles", number), 1000);
}

}  // namespace

TEST_CASE("a part drawn with another look leaves none of the old one's files") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  options.exports = exports({"meshes", "meshes_obj", "particles"});
  REQUIRE(app::run_render(scene(), options) == app::done);
  auto part = options_for(folder / "run");
  part.frames = app::FrameRange{0, 2};
  REQUIRE(app::run_render(scene({green}), part) == app::done);
  const auto report = report_of(part.output);
  CHECK(report.at("complete") == false);
  CHECK(report.at("pictures") == nlohmann::json::parse("[[0, 2]]"));
  CHECK(report.at("videos").size() == 1);
  CHECK(report.at("videos").at(0).at("file") == "video_0000-0002.mp4");
  CHECK(report.at("videos").at(0).at("frames") == 3);
  CHECK(report.at("scene").at("look").at("liquid_color").at(1) == 0.7);
  CHECK(count(part.output / "frames") == 3);
  CHECK_FALSE(fs::exists(part.output / "video.mp4"));
  // The same liquid: its particles and surface are still those of the scene.
  CHECK(count(part.output / "meshes") == 6);
  CHECK(count(part.output / "meshes_obj") == 6);
  CHECK(count(part.output / "particles_ply") == 6);
  const auto whole = options_for(folder / "whole");
  REQUIRE(app::run_render(scene({green}), whole) == app::done);
  require_same_pictures(part.output, whole.output);
}

TEST_CASE("another liquid leaves nothing of the first but its kept particles") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  options.exports = exports({"meshes", "meshes_obj", "particles"});
  const char* probe = R"(probes=[{"name": "e", "energy": {}}])";
  REQUIRE(app::run_render(scene({probe}), options) == app::done);
  auto other = options_for(folder / "run");
  other.simulate_only = true;
  REQUIRE(app::run_render(scene({"fluid.viscosity=1"}), other) == app::done);
  CHECK(files_in(other.output) == std::set<std::string>{"run.json"});
  CHECK(count(other.output / "particles") == 2);
}

TEST_CASE("a part drawn again with the same look changes nothing and keeps the record") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  const char* probe = R"(probes=[{"name": "e", "energy": {}}])";
  REQUIRE(app::run_render(scene({probe}), options) == app::done);
  const auto before = report_of(options.output);
  const std::string video = bytes_of(options.output / "video.mp4"),
                    table = bytes_of(options.output / "probes.csv");
  options.frames = app::FrameRange{1, 2};
  REQUIRE(app::run_render(scene({probe}), options) == app::done);
  const auto after = report_of(options.output);
  CHECK(bytes_of(options.output / "video.mp4") == video);
  CHECK(bytes_of(options.output / "probes.csv") == table);
  CHECK(output::video_length(options.output / "video_0001-0002.mp4") == 2);
  CHECK(after.at("complete") == true);
  CHECK(before.at("steps") > 0);
  CHECK(before.at("boundary_particles") > 0);
  CHECK(before.at("simulation_bytes") > 0);
  CHECK(before.at("simulation_seconds") > 0);
  CHECK(before.at("simulation_phases").size() > 0);
  for (const char* key :
       {"steps", "iterations", "rejected_steps", "worst_mean_compression", "worst_max_compression",
        "boundary_particles", "simulation_bytes", "simulation_seconds", "simulation_phases",
        "backend", "frames", "particles"})
    CHECK(after.at(key) == before.at(key));
}

TEST_CASE("a shorter run removes what is beyond its end") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  options.exports = exports({"meshes", "meshes_obj", "particles"});
  REQUIRE(app::run_render(scene(), options) == app::done);
  auto shorter = options_for(folder / "run");
  shorter.simulate_only = true;
  REQUIRE(app::run_render(scene({"video.duration=0.1"}), shorter) == app::done);
  for (const char* name : {"frames", "meshes", "particles_ply"})
    CHECK(count(shorter.output / name) == 3);
  CHECK_FALSE(fs::exists(shorter.output / "video.mp4"));
}

TEST_CASE("another quality makes the video again and keeps the pictures") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  REQUIRE(app::run_render(scene(), options) == app::done);
  options.simulate_only = true;
  REQUIRE(app::run_render(scene({"video.quality=40"}), options) == app::done);
  CHECK(count(options.output / "frames") == 6);
  CHECK_FALSE(fs::exists(options.output / "video.mp4"));
}

TEST_CASE("damaged particles are made anew, from the good ones before them, to the same bytes") {
  const TemporaryFolder folder;
  const auto options = options_for(folder / "run");
  REQUIRE(app::run_render(scene(), options) == app::done);
  const fs::path kept = fs::directory_iterator(options.output / "particles")->path();
  const std::string frame = bytes_of(kept / "0002.particles"),
                    video = bytes_of(options.output / "video.mp4");
  cut_short(options.output, 2);
  REQUIRE(app::run_render(scene(), options) == app::done);
  CHECK(report_of(options.output).at("frames_simulated") == 1);
  CHECK(bytes_of(kept / "0002.particles") == frame);
  CHECK(bytes_of(options.output / "video.mp4") == video);
  cut_short(options.output, 2);
  auto other = options_for(folder / "other");
  other.from_particles = kept;
  CHECK(app::run_render(scene(), other) == app::run_failed);
  CHECK(report_of(other.output).at("complete") == false);
}

TEST_CASE("two scene files do not share a folder by accident; a renamed one goes on") {
  const TemporaryFolder folder;
  output::write_file(folder / "a.json", "{}");
  output::write_file(folder / "b.json", "{}");
  auto options = options_for(folder / "run");
  options.replace = false;
  options.scene_file = (folder / "a.json").string();
  REQUIRE(app::run_render(scene(), options) == app::done);
  CHECK(report_of(options.output).at("scene_file") == options.scene_file);
  const std::string before = bytes_of(options.output / "run.json");
  options.scene_file = (folder / "b.json").string();
  CHECK_THROWS_WITH(app::run_render(scene({green}), options),
                    Catch::Contains((folder / "a.json").string()) && Catch::Contains("--force"));
  CHECK(bytes_of(options.output / "run.json") == before);
  SECTION("asked for") {
    options.replace = true;
  }
  SECTION("the file has moved") {
    fs::remove(folder / "a.json");
  }
  CHECK(app::run_render(scene({green}), options) == app::done);
  CHECK(report_of(options.output).at("scene_file") == options.scene_file);
}

TEST_CASE("files that no run.json speaks for are not replaced by accident") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  options.replace = false;
  fs::create_directories(options.output / "frames");
  output::write_file(options.output / "frames/0009.png", "somebody's");
  CHECK_THROWS_WITH(app::run_render(scene(), options), Catch::Contains("frames/0009.png"));
  CHECK(bytes_of(options.output / "frames/0009.png") == "somebody's");
  options.replace = true;
  CHECK(app::run_render(scene(), options) == app::done);
  CHECK(count(options.output / "frames") == 6);
}

TEST_CASE("part files of killed runs are gone after the next run, in every subfolder") {
  const TemporaryFolder folder;
  const auto options = options_for(folder / "run");
  REQUIRE(app::run_render(scene(), options) == app::done);
  const fs::path kept = fs::directory_iterator(options.output / "particles")->path();
  const std::vector<fs::path> parts{
      options.output / ".video.77-0.part.mp4", options.output / "frames/.0003.77-0.part.png",
      options.output / "meshes/.0003.77-0.part.ply", kept / ".0003.77-0.part.particles"};
  fs::create_directories(options.output / "meshes");
  for (const fs::path& part : parts)
    output::write_file(part, "half");
  REQUIRE(app::run_render(scene(), options) == app::done);
  for (const fs::path& part : parts)
    CHECK_FALSE(fs::exists(part));
}

TEST_CASE("a folder by the name of the video is noticed before anything is drawn") {
  const TemporaryFolder folder;
  const auto options = options_for(folder / "run");
  fs::create_directories(options.output / "video.mp4");
  CHECK(app::run_render(scene(), options) == app::run_failed);
  for (const std::string& name : files_in(options.output))
    CHECK(name == "run.json");
}

TEST_CASE("frames' figures that are none are not added up") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  REQUIRE(app::run_render(scene(), options) == app::done);
  auto damaged = report_of(options.output);
  damaged["frames"][4].erase("steps");
  damaged["frames"][5]["mean_compression"] = "much";
  output::write_file(options.output / "run.json", damaged.dump());
  options.frames = app::FrameRange{0, 2};
  REQUIRE(app::run_render(scene(), options) == app::done);
  CHECK(report_of(options.output).at("frames").size() == 3);
}

TEST_CASE("a second run in a folder is refused while the first is at work") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  const app::FolderLock lock(options.output, false);
  CHECK_THROWS_WITH(app::run_render(scene(), options), Catch::Contains("at work here"));
  CHECK_FALSE(fs::exists(options.output / "run.json"));
  CHECK(app::run_render(scene(), options, lock) == app::done);
}
