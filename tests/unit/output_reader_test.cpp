// Videos read back.
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdlib>

#include "output_support.hpp"
#include "png_support.hpp"
#include "render/output/output.hpp"

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
  CHECK_THROWS_WITH(VideoReader(folder / "none.mp4"), Contains("none.mp4") && Contains("No such"));
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
