// The render command on a small scene: what it leaves, what it does not do twice, how it ends
// early.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <csignal>
#include <cstdio>
#include <sstream>
#include <thread>

#include "app/system/bounded_queue.hpp"
#include "pipeline_support.hpp"

TEST_CASE("a run leaves its frames, a video and a report") {
  const TemporaryFolder folder;
  const auto options = options_for(folder / "run");
  REQUIRE(app::run_render(scene(), options) == app::done);
  CHECK(count(options.output / "frames") == 6);
  CHECK(fs::file_size(options.output / "video.mp4") > 1000);
  const Image image = output::read_png(options.output / "frames/0005.png");
  CHECK(image.width == 96);
  CHECK(image.height == 64);
  const auto report = report_of(options.output);
  CHECK(report.at("complete") == true);
  CHECK(report.at("particles") == 5 * 8 * 5);
  CHECK(report.at("frames").size() == 6);
  CHECK(report.at("frames_simulated") == 6);
  CHECK(report.at("frames").at(5).at("time") == Approx(5 / 30.));
  CHECK(report.at("frames").at(5).at("steps") > 0);
  CHECK(report.at("frames").at(5).at("max_compression") <= 0.03);
  CHECK(report.at("scene").at("video").at("width") == 96);
  CHECK_FALSE(report.at("gl").at("renderer").get<std::string>().empty());
  CHECK_FALSE(report.at("gl").at("device").get<std::string>().empty());
  CHECK(report.at("stage_seconds").contains("draw"));
}

TEST_CASE("a changed picture does not simulate again; a changed liquid does") {
  const TemporaryFolder folder;
  const auto options = options_for(folder / "run");
  REQUIRE(app::run_render(scene(), options) == app::done);
  const std::string before = bytes_of(options.output / "frames/0003.png");
  REQUIRE(app::run_render(scene({"look.liquid_color=[0.2,0.7,0.3]"}), options) == app::done);
  CHECK(report_of(options.output).at("frames_simulated") == 0);
  CHECK(bytes_of(options.output / "frames/0003.png") != before);
  REQUIRE(app::run_render(scene({"fluid.viscosity=1"}), options) == app::done);
  CHECK(report_of(options.output).at("frames_simulated") == 6);
}

TEST_CASE("a longer run of the same scene goes on from the kept particles, to the same bytes") {
  const TemporaryFolder folder;
  const auto once = options_for(folder / "once"), twice = options_for(folder / "twice");
  REQUIRE(app::run_render(scene(), once) == app::done);
  REQUIRE(app::run_render(scene({"video.duration=0.1"}), twice) == app::done);
  REQUIRE(app::run_render(scene(), twice) == app::done);
  CHECK(report_of(twice.output).at("frames_simulated") == 3);
  for (int k = 0; k < 6; ++k) {
    const std::string name = fmt::format("frames/{:04}.png", k);
    CHECK(bytes_of(once.output / name) == bytes_of(twice.output / name));
  }
  CHECK(bytes_of(once.output / "video.mp4") == bytes_of(twice.output / "video.mp4"));
}

TEST_CASE("pictures and video are the same bytes for one, two and four threads") {
  const TemporaryFolder folder;
  std::vector<std::string> videos;
  for (const int threads : {1, 2, 4}) {
    auto options = options_for(folder / fmt::format("{}", threads).c_str());
    options.threads = threads;
    REQUIRE(app::run_render(scene(), options) == app::done);
    videos.push_back(bytes_of(options.output / "video.mp4") +
                     bytes_of(options.output / "frames/0005.png"));
  }
  CHECK(videos[0] == videos[1]);
  CHECK(videos[0] == videos[2]);
}

TEST_CASE("a range of frames draws only those") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  options.frames = app::FrameRange{2, 3};
  REQUIRE(app::run_render(scene(), options) == app::done);
  CHECK(count(options.output / "frames") == 2);
  CHECK(fs::exists(options.output / "frames/0002.png"));
  CHECK(report_of(options.output).at("complete") == false);
  CHECK(report_of(options.output).at("pictures") == nlohmann::json::parse("[[2, 3]]"));
}

TEST_CASE("pictures left from a longer run go away") {
  const TemporaryFolder folder;
  const auto options = options_for(folder / "run");
  REQUIRE(app::run_render(scene(), options) == app::done);
  REQUIRE(app::run_render(scene({"video.duration=0.1"}), options) == app::done);
  CHECK(count(options.output / "frames") == 3);
}

TEST_CASE("particles kept by one run can be drawn by another") {
  const TemporaryFolder folder;
  const auto options = options_for(folder / "run");
  REQUIRE(app::run_render(scene(), options) == app::done);
  auto other = options_for(folder / "other");
  other.from_particles = fs::directory_iterator(options.output / "particles")->path();
  REQUIRE(app::run_render(scene(), other) == app::done);
  CHECK(report_of(other.output).at("frames_simulated") == 0);
  CHECK(bytes_of(other.output / "frames/0004.png") == bytes_of(options.output / "frames/0004.png"));
}

TEST_CASE("probes are read in every frame or at their rate, and in frames that were kept") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  options.simulate_only = GENERATE(true, false);
  const auto probed = [&](const char* rate) {
    return scene({R"(probes=[{"name": "e", "energy": {}}, {"name": "f", "front": {}}])",
                  fmt::format("probes_rate={}", rate)});
  };
  REQUIRE(app::run_render(probed("0"), options) == app::done);
  const std::string table = bytes_of(options.output / "probes.csv");
  const auto report = report_of(options.output);
  CHECK(report.at("probes").at("table") == "probes.csv");
  std::istringstream lines(table);
  std::string line;
  std::getline(lines, line);
  CHECK(line == "time_s,e_kinetic_J,e_potential_J,e_total_J,f_m");
  for (const auto& frame : report.at("frames")) {
    double time = -1, kinetic = -1, potential = -1;
    REQUIRE(std::getline(lines, line));
    REQUIRE(std::sscanf(line.c_str(), "%lf,%lf,%lf", &time, &kinetic, &potential) == 3);
    CHECK(time == Approx(frame.at("time").get<double>()));
    CHECK(kinetic == Approx(frame.at("kinetic_energy").get<double>()).margin(1e-9));
    CHECK(potential == Approx(frame.at("potential_energy").get<double>()));
  }
  CHECK_FALSE(std::getline(lines, line));
  CHECK_THAT(bytes_of(options.output / "probes.html"), Catch::Contains("<h2>f</h2>"));

  fs::remove(options.output / "probes.csv");
  REQUIRE(app::run_render(probed("0"), options) == app::done);
  CHECK(report_of(options.output).at("frames_simulated") == 0);
  CHECK(bytes_of(options.output / "probes.csv") == table);

  REQUIRE(app::run_render(probed("200"), options) == app::done);
  const std::string often = bytes_of(options.output / "probes.csv");
  CHECK(std::count(often.begin(), often.end(), '\n') == 1 + 34);  // 0, 0.005 ... 0.165 s
  CHECK(report_of(options.output).at("frames").at(5).at("steps") >= 6);
}

TEST_CASE("a scene without probes has no table of them") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  options.simulate_only = true;
  REQUIRE(app::run_render(scene({"probes_rate=500"}), options) == app::done);
  CHECK_FALSE(fs::exists(options.output / "probes.csv"));
  CHECK_FALSE(report_of(options.output).contains("probes"));
}

TEST_CASE("meshes and particles are exported on request, and nothing is drawn by simulate") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  options.exports = exports({"meshes", "meshes_obj", "particles"});
  REQUIRE(app::run_render(scene(), options) == app::done);
  CHECK(count(options.output / "meshes") == 6);
  CHECK(bytes_of(options.output / "meshes/0000.ply").starts_with("ply\n"));
  CHECK(count(options.output / "meshes_obj") == 6);
  CHECK(bytes_of(options.output / "meshes_obj/0000.obj").starts_with("# "));
  CHECK(count(options.output / "particles_ply") == 6);
  auto dry = options_for(folder / "dry");
  dry.simulate_only = true;
  REQUIRE(app::run_render(scene(), dry) == app::done);
  CHECK_FALSE(fs::exists(dry.output / "frames"));
  CHECK_FALSE(fs::exists(dry.output / "video.mp4"));
}

TEST_CASE("a shortened scene tells nothing of what was beyond its end") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  options.simulate_only = true;
  const std::string probes = R"(probes=[{"name": "e", "energy": {}}])";
  REQUIRE(app::run_render(scene({probes}), options) == app::done);
  REQUIRE(app::run_render(scene({probes, "video.duration=0.1"}), options) == app::done);
  const auto report = report_of(options.output);
  REQUIRE(report.at("frames").size() == 3);
  int steps = 0;
  for (const auto& frame : report.at("frames"))
    steps += frame.at("steps").get<int>();
  CHECK(report.at("steps") == steps);
  const std::string table = bytes_of(options.output / "probes.csv");
  CHECK(std::count(table.begin(), table.end(), '\n') == 1 + 3);
}

TEST_CASE("a run.json of other types is as one that says nothing") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  options.simulate_only = true;
  fs::create_directories(options.output);
  for (const char* text : {R"({"scene_file": 5, "made_of": {"probes": null}})",
                           R"({"scene_file": {}, "made_of": [], "frames": 3})"})
    for (const bool replace : {true, false}) {
      options.replace = replace;
      output::write_file(options.output / "run.json", text);
      CHECK(app::run_render(scene({"video.duration=0.1"}), options) == app::done);
      CHECK(report_of(options.output).at("complete") == true);
    }
}

TEST_CASE("liquid still in a nozzle outside the tank is kept, and not exported") {
  const TemporaryFolder folder;
  auto options = options_for(folder / "run");
  options.exports = exports({"particles"});
  options.simulate_only = true;
  const app::Scene fed = scene({R"(fluid.emitters=[{"disc": {"center": [0.7, 0, 0.2],
                                    "direction": [0, 1, 0], "radius": 0.12}, "speed": 1}])"});
  REQUIRE(app::run_render(fed, options) == app::done);
  const std::string last = bytes_of(options.output / "particles_ply/0005.ply");
  const std::size_t count_at = last.find("element vertex ") + 15;
  const std::string simulation = app::simulation_hash(fed);
  const app::ParticleCache cache(options.output / "particles" / simulation, simulation);
  const sim::Frame kept = cache.read(5).frame;
  const auto is_out = [](const glm::vec3& p) { return p.y < 0; };
  const auto out = std::count_if(kept.positions.begin(), kept.positions.end(), is_out);
  CHECK(out > 5);
  CHECK(std::stol(last.substr(count_at)) == static_cast<long>(kept.positions.size()) - out);
}

TEST_CASE("a failure while writing is told, leaves finished frames and a playable video") {
  const TemporaryFolder folder;
  const auto options = options_for(folder / "run");
  // A folder in the place of a frame's file: that frame can't be written.
  fs::create_directories(options.output / "frames/0003.png/in the way");
  CHECK(app::run_render(scene(), options) == app::run_failed);
  CHECK(fs::exists(options.output / "frames/0002.png"));
  CHECK(fs::file_size(options.output / "video.mp4") > 500);
  CHECK(report_of(options.output).at("complete") == false);
}

TEST_CASE("a damaged particle file is an error that names it") {
  const TemporaryFolder folder;
  const auto options = options_for(folder / "run");
  REQUIRE(app::run_render(scene(), options) == app::done);
  const fs::path kept = fs::directory_iterator(options.output / "particles")->path();
  fs::resize_file(kept / "0002.particles", 1000);
  const app::ParticleCache cache(kept);
  CHECK(cache.simulation() == kept.filename());
  CHECK_THROWS_WITH(cache.read(2), Catch::Contains("0002.particles"));
  CHECK_THROWS_WITH(cache.read(99), Catch::Contains("0099.particles"));
}

TEST_CASE("a queue hands over in order, waits when full, and ends when closed") {
  app::BoundedQueue<int> queue(2);
  std::thread giver([&] {
    for (int k = 0; k < 100; ++k)
      queue.push(k);
    queue.close();
  });
  for (int k = 0; k < 100; ++k)
    CHECK(queue.pop() == k);
  CHECK_FALSE(queue.pop().has_value());
  giver.join();
  CHECK_FALSE(queue.push(1));
}

TEST_CASE("a scene that starts empty is drawn, exported, reported, and gone on with") {
  const auto scene_of = [](const app::Overrides& set) {
    return app::parse_scene(R"({
      "fluid": {"spacing": 0.08, "emitters": [
        {"disc": {"center": [0.4, 0.6, 0.2], "direction": [1, 0, 0], "radius": 0.1}, "speed": 2,
         "from": 0.05}]},
      "domain": {"min": [0, 0, 0], "max": [0.96, 0.8, 0.4], "open": ["+x"]},
      "video": {"width": 96, "height": 64, "duration": 0.6}
    })",
                            "tap.json", set);
  };
  const TemporaryFolder folder;
  auto once = options_for(folder / "once"), twice = options_for(folder / "twice");
  once.exports = exports({"meshes", "particles"});
  REQUIRE(app::run_render(scene_of({}), once) == app::done);
  const auto report = report_of(once.output);
  const auto& frames = report.at("frames");
  CHECK(frames.at(0).at("particles") == 0);
  int inside = 0, most = 0;
  for (const auto& frame : frames) {
    inside += frame.at("entered").get<int>() - frame.at("left").get<int>();
    CHECK(frame.at("particles") == inside);
    most = std::max(most, inside);
  }
  CHECK(frames.at(17).at("left") > 0);
  CHECK(report.at("particles") == most);
  CHECK(bytes_of(once.output / "meshes/0000.ply").find("element vertex 0\n") != std::string::npos);
  CHECK(bytes_of(once.output / "particles_ply/0017.ply").find("property uint id\n") !=
        std::string::npos);
  REQUIRE(app::run_render(scene_of({"video.duration=0.3"}), twice) == app::done);
  REQUIRE(app::run_render(scene_of({}), twice) == app::done);
  CHECK(report_of(twice.output).at("frames_simulated") == 9);
  CHECK(bytes_of(once.output / "video.mp4") == bytes_of(twice.output / "video.mp4"));
}
