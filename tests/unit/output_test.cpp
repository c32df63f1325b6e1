#include <catch2/catch.hpp>

#include "output_support.hpp"
#include "png_support.hpp"
#include "render/output/atomic_file.hpp"
#include "render/output/output.hpp"
#include "render/shortage.hpp"

namespace output_tests {

using namespace spindrift;
using namespace spindrift::output_test;
using Catch::Matchers::Contains;

TEST_CASE("A file has its name only after commit") {
  const TemporaryFolder folder;
  const auto name = folder / "report.json";
  output::write_file(name, "old");
  {
    output::AtomicFile file(name);
    file.write("new");
    REQUIRE(file.temporary_name().parent_path() == name.parent_path());
    REQUIRE(file.temporary_name().extension() == ".json");
    REQUIRE(content_of(name) == "old");
    file.commit();
    REQUIRE(content_of(name) == "new");
    REQUIRE_THROWS_AS(file.commit(), std::logic_error);
    REQUIRE_THROWS_AS(file.write("more"), std::logic_error);
  }
  REQUIRE(content_of(name) == "new");
  REQUIRE(folder.entries() == 1);
}

TEST_CASE("A file that is not committed leaves nothing") {
  const TemporaryFolder folder;
  { output::AtomicFile(folder / "report.json").write("half"); }
  REQUIRE(folder.entries() == 0);
}

TEST_CASE("Two writers of one file do not mix") {
  const TemporaryFolder folder;
  const auto name = folder / "report.json";
  output::AtomicFile first(name);
  output::AtomicFile second(name);
  first.write("first");
  second.write("second");
  second.commit();
  first.commit();
  REQUIRE(content_of(name) == "first");
  REQUIRE(folder.entries() == 1);
}

TEST_CASE("Small and large pieces arrive in order") {
  const TemporaryFolder folder;
  std::string expected;
  output::AtomicFile file(folder / "data");
  for (int i = 0; i < 400; ++i) {
    const std::string piece(std::size_t(i) * (i % 50 == 49 ? 3000 : 11), char('a' + i % 26));
    file.write(piece);
    expected += piece;
  }
  file.commit();
  REQUIRE(content_of(folder / "data") == expected);
}

TEST_CASE("A name without an extension and a very long name work") {
  const TemporaryFolder folder;
  const std::string long_name = std::string(240, 'x') + ".ply";
  output::write_file(folder / "plain", "1");
  output::write_file(folder / long_name.c_str(), "2");
  REQUIRE(content_of(folder / "plain") == "1");
  REQUIRE(content_of(folder / long_name.c_str()) == "2");
}

TEST_CASE("A file that cannot be created is an error with its name and the reason") {
  const TemporaryFolder folder;
  REQUIRE_THROWS_WITH(output::write_file(folder / "none/report.json", "x"),
                      Contains("none/report.json") && Contains("No such file or directory"));
  output::write_file(folder / "file", "x");
  REQUIRE_THROWS_WITH(output::write_file(folder / "file/report.json", "x"),
                      Contains("file/report.json") && Contains("Not a directory"));
  std::filesystem::create_directory(folder / "taken.json");
  REQUIRE_THROWS_WITH(output::write_file(folder / "taken.json", "x"),
                      Contains("taken.json") && Contains("Is a directory"));
  if (::geteuid() != 0) {  // root may write everywhere
    std::filesystem::create_directory(folder / "locked");
    std::filesystem::permissions(folder / "locked", std::filesystem::perms::owner_read);
    REQUIRE_THROWS_WITH(output::write_file(folder / "locked/report.json", "x"),
                        Contains("locked/report.json") && Contains("Permission denied"));
  }
}

TEST_CASE("A file where a folder is to be is named") {
  const TemporaryFolder folder;
  output::write_file(folder / "out", "");
  CHECK_THROWS_WITH(output::make_folders(folder / "out"), Catch::EndsWith("out is a file"));
  CHECK_THROWS_WITH(output::make_folders(folder / "out/run/frames"),
                    Catch::StartsWith("cannot make the folder " + (folder / "out/run").string()) &&
                        Catch::EndsWith(": " + (folder / "out").string() + " is a file"));
  output::make_folders(folder / "new/run");
  output::make_folders(folder / "new/run");
  CHECK(std::filesystem::is_directory(folder / "new/run"));
}

TEST_CASE("A device is never replaced by a file") {
  REQUIRE_THROWS_WITH(output::write_file("/dev/null", "x"), Contains("/dev/null"));
  REQUIRE(std::filesystem::is_character_file("/dev/null"));
}

TEST_CASE("A full disk is an error with the name of the file, and leaves nothing") {
  const TemporaryFolder folder;
  REQUIRE(fails_when_full(100, "report.json", [&] {
    output::write_file(folder / "report.json", std::string(1000, 'x'));
  }));
  REQUIRE(fails_when_full(100, "report.json", [&] {
    output::write_file(folder / "report.json", std::string(1000000, 'x'));
  }));
  REQUIRE(fails_when_full(100, "a.png",
                          [&] { output::write_png(folder / "a.png", noise(64, 64, 1)); }));
  REQUIRE(folder.entries() == 0);
}

TEST_CASE("A picture comes back from PNG bit by bit") {
  const TemporaryFolder folder;
  const auto name = folder / "a.png";
  const auto same = [&](const Image& image) {
    output::write_png(name, image);
    const Image back = output::read_png(name);
    return back.width == image.width && back.height == image.height && back.pixels == image.pixels;
  };
  REQUIRE(same(noise(640, 360, 1)));
  REQUIRE(same(waves(1280, 720, 0.0)));
  REQUIRE(same(solid(256, 256, 1, 2, 3)));
  for (const int width : {1, 2, 3, 7, 333}) {
    for (const int height : {1, 2, 5, 101}) {
      CAPTURE(width, height);
      REQUIRE(same(noise(width, height, 7)));
    }
  }
  REQUIRE(folder.entries() == 1);
}

TEST_CASE("A PNG starts with its signature and carries an sRGB tag before the pixels") {
  const TemporaryFolder folder;
  output::write_png(folder / "a.png", noise(9, 4, 1));
  const std::string png = content_of(folder / "a.png");
  REQUIRE(png.substr(0, 8) == "\x89PNG\r\n\x1a\n");
  REQUIRE(png.substr(12, 4) == "IHDR");
  // Length 1, name, intent 0, and the checksum as in the PNG files of other programs.
  const char chunk[] = "\0\0\0\1sRGB\0\xAE\xCE\x1C\xE9";
  REQUIRE(png.substr(33, 13) == std::string(chunk, 13));
  REQUIRE(png.find("IDAT") == 33 + 13 + 4);
  REQUIRE(png.substr(png.size() - 8, 4) == "IEND");
}

TEST_CASE("The same picture gives the same PNG, and a smooth one a small PNG") {
  const TemporaryFolder folder;
  const Image image = waves(1280, 720, 0.5);
  output::write_png(folder / "a.png", image);
  output::write_png(folder / "b.png", image);
  REQUIRE(content_of(folder / "a.png") == content_of(folder / "b.png"));
  REQUIRE(std::filesystem::file_size(folder / "a.png") < image.pixels.size() / 4);
}

TEST_CASE("A picture without pixels or with too few is rejected") {
  const TemporaryFolder folder;
  Image few(8, 8);
  few.pixels.pop_back();
  REQUIRE_THROWS_AS(output::write_png(folder / "a.png", Image()), std::invalid_argument);
  REQUIRE_THROWS_AS(output::write_png(folder / "a.png", few), std::invalid_argument);
  REQUIRE(folder.entries() == 0);
}

TEST_CASE("A PNG that cannot be read is an error with its name") {
  const TemporaryFolder folder;
  REQUIRE_THROWS_WITH(output::read_png(folder / "none.png"),
                      Contains("none.png") && Contains("no such file"));
  REQUIRE_THROWS_WITH(output::read_png(folder / ""), Contains("is a folder"));
  output::write_file(folder / "text.png", "not a picture");
  REQUIRE_THROWS_WITH(output::read_png(folder / "text.png"), Contains("text.png"));
  output::write_file(folder / "empty.png", "");
  REQUIRE_THROWS_WITH(output::read_png(folder / "empty.png"), Contains("empty.png"));
  output::write_png(folder / "cut.png", noise(64, 64, 1));
  std::filesystem::resize_file(folder / "cut.png", 500);
  REQUIRE_THROWS_WITH(output::read_png(folder / "cut.png"), Contains("cut.png"));
}

TEST_CASE("A PNG of any kind is read as it is, or refused where 8-bit RGB cannot hold it") {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& png) {
    output::write_file(folder / "a.png", png);
    return output::read_png(folder / "a.png").pixels;
  };
  using Samples = std::vector<std::uint8_t>;
  const std::string rgb = "\1\2\3\4\5\6";
  CHECK(read(one_row_png(PngColour::rgb, 8, 2, rgb)) == Samples{1, 2, 3, 4, 5, 6});
  CHECK(read(one_row_png(PngColour::grey, 8, 2, "\x07\x80")) == Samples{7, 7, 7, 128, 128, 128});
  CHECK(read(one_row_png(PngColour::grey, 1, 2, "\x40")) == Samples{0, 0, 0, 255, 255, 255});
  CHECK(read(one_row_png(PngColour::palette, 8, 2, std::string("\1\0", 2),
                         png_chunk("PLTE", rgb))) == Samples{4, 5, 6, 1, 2, 3});
  CHECK(read(one_row_png(PngColour::rgb_alpha, 8, 1, "\1\2\3\xff")) == Samples{1, 2, 3});
  CHECK(read(one_row_png(PngColour::grey_alpha, 8, 1, "\x09\xff")) == Samples{9, 9, 9});
  CHECK(read(one_row_png(PngColour::rgb, 16, 1, "\1\1\2\2\xff\xff")) == Samples{1, 2, 255});
  // Sanitizers find what stb does with a chunk of pixels that has none.
  CHECK(read(one_row_png(PngColour::rgb, 8, 2, rgb, png_chunk("IDAT", ""))) ==
        Samples{1, 2, 3, 4, 5, 6});

  const auto refused = [&](const std::string& png, const char* why) {
    CHECK_THROWS_WITH(read(png), Contains("a.png") && Contains(why));
  };
  refused(one_row_png(PngColour::rgb_alpha, 8, 1, "\1\2\3\xfe"), "transparent");
  refused(one_row_png(PngColour::grey_alpha, 8, 1, std::string("\x09\0", 2)), "transparent");
  refused(one_row_png(PngColour::palette, 8, 1, "\1",
                      png_chunk("PLTE", rgb) + png_chunk("tRNS", "\xff\x80")),
          "transparent");
  refused(one_row_png(PngColour::rgb, 8, 1, "\1\2\3",
                      png_chunk("tRNS", std::string("\0\1\0\2\0\3", 6))),
          "transparent");
  refused(one_row_png(PngColour::rgb, 16, 1, "\1\1\2\3\xff\xff"), "16-bit");
  refused(one_row_png(PngColour::grey, 16, 1, "\1\2"), "16-bit");
  refused(one_row_png(PngColour::rgb, 8, 1, "\1\2\3",
                      png_chunk("acTL", std::string("\0\0\0\2\0\0\0\0", 8))),
          "animated");
}

TEST_CASE("What the system gives too little of is told with the limit") {
  CHECK(shortage() == std::nullopt);
  rlimit before{};
  REQUIRE(::getrlimit(RLIMIT_NOFILE, &before) == 0);
  rlimit none = before;
  none.rlim_cur = 0;
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &none) == 0);
  const auto found = shortage();
  REQUIRE(::setrlimit(RLIMIT_NOFILE, &before) == 0);
  REQUIRE(found);
  CHECK_THAT(*found, Contains("open no file more; the limit is 0 files (ulimit -n)"));
  const auto too_much = shortage(std::size_t{1} << 62);
  REQUIRE(too_much);
  CHECK_THAT(*too_much, Contains("MiB of memory more"));
}

}  // namespace output_tests
