// What becomes of a video's file: its name, and errors that leave nothing.
#include <sys/mman.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <vector>

#include "video_support.hpp"

namespace output_video_file_tests {

using namespace spindrift;
using namespace spindrift::output_test;
using Catch::Matchers::Contains;

TEST_CASE("A video has its name only when finished") {
  const TemporaryFolder folder;
  output::VideoWriter writer(folder / "v.mp4", small_video());
  for (int i = 0; i < 60; ++i)
    writer.add(waves(320, 180, i / 30.0));
  REQUIRE_FALSE(std::filesystem::exists(folder / "v.mp4"));
  writer.finish();
  REQUIRE(std::filesystem::exists(folder / "v.mp4"));
  REQUIRE(folder.entries() == 1);
  writer.finish();
  REQUIRE(folder.entries() == 1);
  REQUIRE_THROWS_AS(writer.add(waves(320, 180, 0)), std::logic_error);
}

TEST_CASE("An interrupted video leaves a playable file of what was added") {
  const TemporaryFolder folder;
  try {
    output::VideoWriter writer(folder / "v.mp4", small_video());
    for (int i = 0; i < 7; ++i)
      writer.add(waves(320, 180, i / 30.0));
    throw std::runtime_error("interrupted");
  } catch (const std::runtime_error&) {
  }
  REQUIRE(read_video(folder / "v.mp4").frames.size() == 7);
  REQUIRE(folder.entries() == 1);
}

TEST_CASE("A video without a frame leaves no file") {
  const TemporaryFolder folder;
  { const output::VideoWriter writer(folder / "v.mp4", small_video()); }
  REQUIRE(folder.entries() == 0);
  {
    output::VideoWriter writer(folder / "v.mp4", small_video());
    REQUIRE_THROWS_AS(writer.finish(), std::logic_error);
  }
  REQUIRE(folder.entries() == 0);
}

TEST_CASE("Bad settings of a video are rejected before a file is touched") {
  const TemporaryFolder folder;
  const auto rejected = [&](int width, int height, int rate, int quality) {
    REQUIRE_THROWS_AS(output::VideoWriter(folder / "v.mp4", {width, height, rate, quality}),
                      std::invalid_argument);
  };
  rejected(321, 180, 30, 18);
  rejected(320, 181, 30, 18);
  rejected(0, 180, 30, 18);
  rejected(320, -2, 30, 18);
  rejected(320, 180, 0, 18);
  rejected(320, 180, 1001, 18);
  rejected(320, 180, 30, -1);
  rejected(320, 180, 30, 52);
  REQUIRE(folder.entries() == 0);
}

TEST_CASE("A frame of another size is rejected and the video goes on without it") {
  const TemporaryFolder folder;
  output::VideoWriter writer(folder / "v.mp4", small_video());
  Image few(320, 180);
  few.pixels.pop_back();
  writer.add(waves(320, 180, 0));
  REQUIRE_THROWS_AS(writer.add(waves(180, 320, 0)), std::invalid_argument);
  REQUIRE_THROWS_AS(writer.add(few), std::invalid_argument);
  writer.add(waves(320, 180, 0));
  writer.finish();
  REQUIRE(read_video(folder / "v.mp4").frames.size() == 2);
}

TEST_CASE("Nothing behind a frame's last pixel is read") {
  const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
  Image image;
  image.pixels.reserve(1 << 20);
  const std::uint8_t* begin = image.pixels.data();
  output::VideoSettings settings = small_video();
  const auto size = [&] { return std::size_t(3 * settings.width * settings.height); };
  // It ends where a page of memory does, and the page behind it can't be read.
  while ((reinterpret_cast<std::uintptr_t>(begin) + size()) % page != 0)
    settings.width += 2;
  image.width = settings.width;
  image.height = settings.height;
  image.pixels.resize(size(), 100);
  REQUIRE(image.pixels.data() == begin);
  std::uint8_t* behind = image.pixels.data() + size();
  const TemporaryFolder folder;
  REQUIRE(mprotect(behind, page, PROT_NONE) == 0);
  output::VideoWriter writer(folder / "v.mp4", settings);
  writer.add(image);
  REQUIRE(mprotect(behind, page, PROT_READ | PROT_WRITE) == 0);
  writer.finish();
}

TEST_CASE("A video that cannot be created is an error with its name") {
  const TemporaryFolder folder;
  REQUIRE_THROWS_WITH(output::VideoWriter(folder / "none/v.mp4", small_video()),
                      Contains("none/v.mp4") && Contains("No such file or directory"));
  std::filesystem::create_directory(folder / "taken.mp4");
  REQUIRE_THROWS_WITH(output::VideoWriter(folder / "taken.mp4", small_video()),
                      Contains("taken.mp4") && Contains("Is a directory"));
  output::VideoSettings huge = small_video();
  huge.width = 1000000;
  REQUIRE_THROWS_WITH(output::VideoWriter(folder / "huge.mp4", huge), Contains("huge.mp4"));
}

TEST_CASE("A disk that fills up under a video is an error, and leaves nothing") {
  const TemporaryFolder folder;
  for (const std::size_t limit : {std::size_t(10), std::size_t(2000), std::size_t(600000)}) {
    CAPTURE(limit);
    REQUIRE(fails_when_full(limit, "v.mp4", [&] {
      output::VideoWriter writer(folder / "v.mp4", small_video());
      for (std::uint32_t i = 0; i < 60; ++i)
        writer.add(noise(320, 180, i));
      writer.finish();
    }));
    REQUIRE(folder.entries() == 0);
  }
}

TEST_CASE("A disk that fills up stops a video while frames are added, not only at the end") {
  const TemporaryFolder folder;
  REQUIRE(fails_when_full(600000, "v.mp4", [&] {
    output::VideoWriter writer(folder / "v.mp4", small_video());
    for (std::uint32_t i = 0; i < 200; ++i)
      writer.add(noise(320, 180, i));
  }));
  REQUIRE(folder.entries() == 0);
}

TEST_CASE("A path with a colon and spaces is a path") {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "http:a b");
  write_waves(folder / "http:a b/v é.mp4", small_video(), 2);
  REQUIRE(read_video(folder / "http:a b/v é.mp4").frames.size() == 2);
}

TEST_CASE("The encoder is named with the versions of its libraries") {
  REQUIRE_THAT(output::encoder_info(),
               Contains("264") && Contains("libavcodec ") && Contains("libavformat "));
}

}  // namespace output_video_file_tests
