// Videos read back.
#include <sys/stat.h>

#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>
#include <future>

#include "output_support.hpp"
#include "png_support.hpp"
#include "render/output/atomic_file.hpp"
#include "render/output/output.hpp"

namespace output_reader_tests {

using namespace spindrift;
using namespace spindrift::output;
using namespace spindrift::output_test;
using Catch::Matchers::Contains;

namespace {

double mean_error(const Image& a, const Image& b) {
  REQUIRE(a.width == b.width);
  REQUIRE(a.height == b.height);
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i)
    sum += std::abs(int{a.pixels[i]} - int{b.pixels[i]});
  return sum / double(a.pixels.size());
}

}  // namespace

TEST_CASE("a video is read picture by picture, in order and in its colours") {
  const TemporaryFolder folder;
  const auto file = folder / "a: b.mp4";
  const std::vector<Image> pictures{solid(98, 50, 200, 30, 40), waves(98, 50, 0), waves(98, 50, 1),
                                    solid(98, 50, 20, 60, 220)};
  {
    VideoWriter writer(file, {.width = 98, .height = 50, .quality = 1});
    for (const Image& picture : pictures)
      writer.add(picture);
    writer.finish();
  }
  VideoReader reader(file);
  for (const Image& picture : pictures) {
    const auto read = reader.next();
    REQUIRE(read);
    CHECK(mean_error(*read, picture) < 1.5);
  }
  CHECK_FALSE(reader.next());
  CHECK_FALSE(reader.next());
}

TEST_CASE("pictures that 8-bit RGB cannot hold are refused, and taken where they are opaque") {
  const TemporaryFolder folder;
  const auto picture = [&](PngColour colour, int depth, const std::string& samples) {
    std::ofstream(folder / "a.png", std::ios::binary) << one_row_png(colour, depth, 1, samples);
    return VideoReader(folder / "a.png").next();
  };
  const auto opaque = picture(PngColour::rgb_alpha, 8, "\1\2\3\xff");
  REQUIRE(opaque);
  CHECK(opaque->pixels == std::vector<std::uint8_t>{1, 2, 3});
  CHECK_THROWS_WITH(picture(PngColour::rgb_alpha, 8, "\1\2\3\xfe"), Contains("transparent"));
  CHECK_THROWS_WITH(picture(PngColour::rgb, 16, "\1\1\2\3\4\4"), Contains("8 bits"));
}

TEST_CASE("what is not a video is refused by name") {
  const TemporaryFolder folder;
  std::ofstream(folder / "text.mp4") << "no video";
  CHECK_THROWS_WITH(VideoReader(folder / "text.mp4"), Contains("text.mp4") && Contains("Invalid"));
  CHECK_THROWS_WITH(VideoReader(folder / "none.mp4"),
                    Contains("none.mp4") && Contains("no such file"));
  REQUIRE(::mkfifo((folder / "pipe.mp4").c_str(), 0600) == 0);
  CHECK_THROWS_WITH(VideoReader(folder / "pipe.mp4"), Contains("is a pipe"));
}

TEST_CASE("a video is read from its own file alone, whatever it names") {
  const TemporaryFolder folder;
  write_png(folder / "a.png", solid(16, 16, 1, 2, 3));
  std::ofstream(folder / "list.m3u8") << "#EXTM3U\n#EXT-X-TARGETDURATION:1\n#EXTINF:1,\n"
                                      << (folder / "a.png").string() << "\n#EXT-X-ENDLIST\n";
  std::ofstream(folder / "list.ffconcat") << "ffconcat version 1.0\nfile a.png\nduration 1\n";
  for (const char* name : {"list.m3u8", "list.ffconcat"})
    CHECK_THROWS_WITH(VideoReader(folder / name), Contains(name));
  CHECK(VideoReader(folder / "a.png").next());
}

TEST_CASE("a damaged video is read as far as it goes, or refused by name") {
  const TemporaryFolder folder;
  {
    VideoWriter writer(folder / "whole.mp4", {.width = 32, .height = 32});
    for (int k = 0; k < 3; ++k)
      writer.add(waves(32, 32, k));
    writer.finish();
  }
  const std::string whole = content_of(folder / "whole.mp4");
  const auto read = [&](const std::string& bytes) {
    write_file(folder / "damaged.mp4", bytes);
    try {
      VideoReader reader(folder / "damaged.mp4");
      while (const auto picture = reader.next())
        CHECK(picture->pixels.size() == std::size_t(3 * picture->width * picture->height));
    } catch (const std::runtime_error& error) {
      CHECK_THAT(error.what(), Contains("damaged.mp4"));
    }
  };
  for (std::size_t size = 0; size < whole.size(); size += 7)
    read(whole.substr(0, size));
  for (std::size_t k = 0; k < whole.size(); k += 5) {
    std::string bytes = whole;
    bytes[k] = static_cast<char>(~bytes[k]);
    read(bytes);
  }
}

TEST_CASE("a damaged PNG is refused in words, whatever stb says of it") {
  const TemporaryFolder folder;
  const auto bytes = encode_png(waves(24, 16, 0));
  const std::string whole(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto complaint = [&](const std::string& png) -> std::string {
    write_file(folder / "damaged.png", png);
    try {
      read_png(folder / "damaged.png");
      return "";
    } catch (const std::runtime_error& error) {
      CHECK_THAT(error.what(), Contains("damaged.png"));
      return error.what();
    }
  };
  const std::size_t pixels = whole.find("IDAT");
  for (std::size_t size = 0; size < pixels + 8; ++size)
    CHECK_FALSE(complaint(whole.substr(0, size)).empty());
  for (std::size_t k = 0; k < whole.size(); ++k) {
    std::string png = whole;
    png[k] = static_cast<char>(~png[k]);
    complaint(png);
  }
  const auto with = [&](std::size_t place, const std::string& other) {
    std::string png = whole;
    return png.replace(place, other.size(), other);
  };
  // The lengths of a chunk for which stb gives no reason. It keeps its last one for each thread.
  for (const char* length : {"\x80\0\0\0", "\xff\xff\xff\xf0", "\xc0\0\0\1", "\x7f\xff\xff\xff"}) {
    const std::string png = with(pixels - 4, std::string(length, 4));
    CHECK_THAT(std::async(std::launch::async, complaint, png).get(), Contains("cut short"));
  }
}

TEST_CASE("a PNG with more pixels than it can hold is refused before memory is taken") {
  const TemporaryFolder folder;
  const auto bytes = encode_png(solid(8, 8, 1, 2, 3));
  const auto sized = [&](std::string width_and_height) {
    std::string png(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    png.replace(16, 8, width_and_height);
    write_file(folder / "large.png", png);
    return folder / "large.png";
  };
  const std::string most = "\x7f\xff\xff\xff", none(4, '\0'), much("\0\0\x20\0", 4);
  CHECK_THROWS_WITH(read_png(sized(most + most)), Contains("2147483647x2147483647 pixels"));
  CHECK_THROWS_WITH(read_png(sized(none + much)), Contains("0x8192 pixels; accepted: 1 to"));
  CHECK_THROWS_WITH(read_png(sized(much + much)), Contains("cut short"));
  REQUIRE(::mkfifo((folder / "pipe.png").c_str(), 0600) == 0);
  CHECK_THROWS_WITH(read_png(folder / "pipe.png"), Contains("is a pipe"));
  CHECK(video_length(folder / "pipe.png") == 0);
}

TEST_CASE("a playlist has no length, whatever the videos that it names have") {
  const TemporaryFolder folder;
  VideoWriter writer(folder / "two.mp4", {.width = 32, .height = 32});
  for (int k = 0; k < 2; ++k)
    writer.add(solid(32, 32, 50, 60, 70));
  writer.finish();
  CHECK(video_length(folder / "two.mp4") == 2);
  write_file(folder / "video.mp4", "ffconcat version 1.0\nfile two.mp4\n");
  CHECK(video_length(folder / "video.mp4") == 0);
}

TEST_CASE("an encoded PNG is the file's content") {
  const TemporaryFolder folder;
  const Image image = waves(20, 10, 0);
  write_png(folder / "a.png", image);
  const auto bytes = encode_png(image);
  CHECK(content_of(folder / "a.png") ==
        std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  CHECK_THROWS_AS(encode_png(Image()), std::invalid_argument);
}

}  // namespace output_reader_tests
