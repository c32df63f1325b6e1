// Cached particles that were damaged, locks of folders, threads that can't be had.
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <catch2/catch.hpp>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <thread>

#include "app/cache/particle_cache.hpp"
#include "app/cache/simulation_record.hpp"
#include "app/files/folder_lock.hpp"
#include "app/run/progress.hpp"
#include "app/system/heartbeat.hpp"
#include "output_support.hpp"
#include "render/output/atomic_file.hpp"
#include "render/output/input_file.hpp"

namespace fs = std::filesystem;
namespace app_cache_tests {

using namespace spindrift;
using output_test::TemporaryFolder;

namespace {

const std::string hash(32, 'a'), other_hash(32, 'b');

app::CachedFrame cached_frame(std::size_t particles) {
  app::CachedFrame cached;
  sim::Frame& frame = cached.frame;
  frame.time = 0.5;
  frame.last_time_step = 0.001;
  for (std::size_t i = 0; i < particles; ++i) {
    const auto x = static_cast<float>(i);
    frame.positions.push_back({x, 1, 2});
    frame.velocities.push_back({3, x, 4});
    frame.densities.push_back(1000 + x);
    frame.pressures.push_back(x);
    frame.constraint_multipliers.push_back(-x);
    frame.ids.push_back(static_cast<std::uint32_t>(i));
  }
  frame.boundary_pressures = {5, 6, 7};
  cached.statistics.steps = 12;
  return cached;
}

void flip_bit(const fs::path& file, std::size_t byte) {
  std::string bytes = output::read_file(file);
  bytes[byte] = static_cast<char>(bytes[byte] ^ 4);
  output::write_file(file, bytes);
}

}  // namespace

TEST_CASE("a cached frame is read as it was written, and not with one bit flipped anywhere") {
  const TemporaryFolder folder;
  const app::ParticleCache cache(folder / "cache", hash);
  const app::CachedFrame cached = cached_frame(20);
  cache.write(3, cached);
  const app::CachedFrame read = cache.read(3);
  CHECK(read.frame.positions == cached.frame.positions);
  CHECK(read.frame.ids == cached.frame.ids);
  CHECK(read.frame.boundary_pressures == cached.frame.boundary_pressures);
  CHECK(read.statistics.steps == 12);
  for (std::size_t byte = 0; byte < fs::file_size(cache.file(3)); byte += 7) {
    flip_bit(cache.file(3), byte);
    CHECK_FALSE(cache.find(3));
    CHECK_THROWS_WITH(cache.read(3), Catch::Contains("0003.particles"));
    flip_bit(cache.file(3), byte);
  }
  CHECK(cache.find(3));
}

TEST_CASE("what is no good file of a frame is not there, and gives way to one that is") {
  const TemporaryFolder folder;
  const app::ParticleCache cache(folder / "cache", hash);
  cache.write(0, cached_frame(20));
  const fs::path file = cache.file(0);
  const std::string good = output::read_file(file);
  SECTION("emptied") {
    output::write_file(file, "");
  }
  SECTION("cut short") {
    fs::resize_file(file, good.size() - 1);
  }
  SECTION("cut to its header") {
    fs::resize_file(file, 100);
  }
  SECTION("lengthened") {
    output::write_file(file, good + "x");
  }
  SECTION("of an older version") {
    output::write_file(file, "SPNDFRM4" + good.substr(8));
  }
  SECTION("of another frame") {
    cache.write(1, cached_frame(20));
    fs::rename(cache.file(1), file);
  }
  SECTION("of another simulation") {
    const app::ParticleCache other(folder / "other", other_hash);
    other.write(0, cached_frame(20));
    fs::rename(other.file(0), file);
  }
  SECTION("a folder") {
    fs::remove(file);
    fs::create_directories(file / "in the way");
  }
  SECTION("a pipe") {
    fs::remove(file);
    REQUIRE(::mkfifo(file.c_str(), 0666) == 0);
  }
  CHECK_FALSE(cache.find(0));
  CHECK_THROWS_WITH(cache.read(0), Catch::Contains("0000.particles"));
  cache.write(0, cached_frame(20));
  CHECK(output::read_file(file) == good);
}

TEST_CASE("readings between frames are read as they were written, or not at all") {
  const TemporaryFolder folder;
  const app::ParticleCache cache(folder / "cache", hash);
  const std::vector<double> values{0.1, 2, 0.2, 3};
  cache.write_readings(2, "p.readings", values);
  CHECK(cache.read_readings(2, "p.readings") == values);
  CHECK_FALSE(cache.read_readings(1, "p.readings"));
  flip_bit(folder / "cache/0002.p.readings", 60);
  CHECK_FALSE(cache.read_readings(2, "p.readings"));
  cache.write_readings(2, "p.readings", {});
  CHECK(cache.read_readings(2, "p.readings")->empty());
}

TEST_CASE("how particles came about is kept beside them") {
  const TemporaryFolder folder;
  const app::ParticleCache cache(folder / "cache", hash);
  CHECK_FALSE(cache.read_record());
  app::SimulationRecord record{.scene_name = "a",
                               .scene_file = "/a.json",
                               .backend = sim::BackendChoice{sim::Backend::cpu, "asked for"},
                               .boundary_particles = 7,
                               .bytes = 100,
                               .seconds = 2,
                               .phases = {{"density", 1, 3}}};
  record.add_phases({{"density", 2, 4}, {"forces", 5, 6}});
  cache.write_record(record);
  const auto read = cache.read_record();
  REQUIRE(read);
  CHECK(read->boundary_particles == 7);
  CHECK(read->backend->reason == "asked for");
  REQUIRE(read->phases.size() == 2);
  CHECK(read->phases[0].seconds == 3);
  CHECK(read->phases[0].calls == 7);
  output::write_file(folder / "cache/simulation.json", "[1]");
  CHECK_FALSE(cache.read_record());
}

TEST_CASE("a folder is locked for one process, which is named to the next") {
  const TemporaryFolder folder;
  const fs::path run = folder / "run";
  {
    const app::FolderLock lock(run, false);
    CHECK_THROWS_WITH(app::FolderLock(run, false),
                      Catch::Contains(run.string()) &&
                          Catch::Contains("(process " + std::to_string(::getpid()) + ")") &&
                          Catch::Contains("test_app") && Catch::Contains("since 20"));
  }
  const app::FolderLock again(run, false);
}

TEST_CASE("part files of killed processes go when the folder is locked, and nothing else") {
  const TemporaryFolder folder;
  const std::vector<std::string> parts{".video.12-0.part.mp4", ".0001.5-1.part.png", ".x.7-0.part"};
  const std::vector<std::string> others{".part.png", ".my.part.zip", "video.12-0.part.mp4", ".a-b"};
  for (const auto& names : {parts, others})
    for (const std::string& name : names)
      output::write_file(folder / name.c_str(), "x");
  const app::FolderLock lock(folder / ".", false);
  for (const std::string& name : parts)
    CHECK_FALSE(fs::exists(folder / name.c_str()));
  for (const std::string& name : others)
    CHECK(fs::exists(folder / name.c_str()));
}

TEST_CASE("a log is told at the beginning and after each tenth") {
  app::LogPace pace;
  int told = 0;
  for (int k = 0; k <= 1000; ++k)
    told += pace.is_due(k / 1000.);
  CHECK(told == 11);
}

TEST_CASE("a log shows life while one frame takes long, and no more once it is over") {
  std::atomic<int> told = 0;
  {
    const app::Heartbeat heartbeat(std::chrono::milliseconds(5), [&] { ++told; });
    while (told < 2)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  const int in_all = told;
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  CHECK(told == in_all);
}

}  // namespace app_cache_tests
