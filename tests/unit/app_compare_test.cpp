// The command that compares pictures, folders, videos and runs.
#include <catch2/catch.hpp>
#include <limits>
#include <nlohmann/json.hpp>

#include "app/commands/commands.hpp"
#include "app/compare/comparison.hpp"
#include "output_support.hpp"
#include "png_support.hpp"
#include "render/output/atomic_file.hpp"
#include "render/output/output.hpp"

namespace app_compare_tests {

using namespace spindrift;
using namespace spindrift::app;
using namespace spindrift::output_test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

/// Pictures of waves in a folder, as 0000.png and on.
void write_waves(const fs::path& folder, int count, double shift = 0) {
  fs::create_directories(folder);
  for (int k = 0; k < count; ++k)
    output::write_png(folder / ("000" + std::to_string(k) + ".png"),
                      waves(64, 36, 0.1 * k + shift));
}

CompareOptions options_for(const fs::path& a, const fs::path& b, const TemporaryFolder& folder) {
  CompareOptions options;
  options.a = a;
  options.b = b;
  options.output = folder / "out";
  options.quiet = true;
  return options;
}

nlohmann::json result_in(const TemporaryFolder& folder) {
  return nlohmann::json::parse(content_of(folder / "out" / "compare.json"));
}

}  // namespace

TEST_CASE("folders are compared picture by picture, and a report is left") {
  const TemporaryFolder folder;
  write_waves(folder / "a", 3);
  write_waves(folder / "b", 3);
  output::write_png(folder / "b" / "0001.png", waves(64, 36, 0.7));
  const CompareOptions options = options_for(folder / "a", folder / "b", folder);
  REQUIRE(run_compare(options) == done);
  const auto json = result_in(folder);
  REQUIRE(json["pairs"].size() == 3);
  CHECK(json["pairs"][0]["flip"]["mean"] == 0);
  CHECK(json["pairs"][0]["psnr"].is_null());  // infinite
  CHECK(json["pairs"][1]["name"] == "0001.png");
  CHECK(json["pairs"][1]["flip"]["mean"] > 0.1);
  CHECK(json["overall"]["flip"]["mean"].get<double>() ==
        Approx(json["pairs"][1]["flip"]["mean"].get<double>() / 3));
  const std::string page = content_of(folder / "out" / "compare.html");
  CHECK_THAT(page, Contains("data:image/png;base64,") && Contains("0001.png"));
  CHECK_THAT(page, !Contains("src=\"http") && !Contains("<link"));
  const Image equal = output::read_png(folder / "out" / "differences" / "0000.png");
  CHECK((equal.pixels[0] == 0 && equal.pixels[2] == 4));
}

TEST_CASE("records of runs that are no records are left out of a comparison") {
  const TemporaryFolder folder;
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  for (const std::string& text :
       {std::string("{"), std::string("[]"), "{\"scene\": " + deep + "}"}) {
    for (const char* run : {"a", "b"}) {
      write_waves(folder / run, 1);
      std::ofstream(folder / run / "run.json") << text;
    }
    REQUIRE(run_compare(options_for(folder / "a", folder / "b", folder)) == done);
  }
}

TEST_CASE("every pair must be within the limits, not their mean") {
  const TemporaryFolder folder;
  write_waves(folder / "a", 4);
  write_waves(folder / "b", 4);
  output::write_png(folder / "b" / "0002.png", waves(64, 36, 0.7));
  CompareOptions options = options_for(folder / "a", folder / "b", folder);
  const auto code = [&](auto Limits::*limit, double value) {
    options.limits = {};
    options.limits.*limit = value;
    return run_compare(options);
  };
  run_compare(options);
  const auto pair = result_in(folder)["pairs"][2];
  for (const auto& [limit, found] :
       {std::pair(&Limits::max_flip, pair["flip"]["mean"].get<double>()),
        std::pair(&Limits::max_changed, pair["changed"].get<double>())}) {
    CHECK(code(limit, found) == done);
    CHECK(code(limit, 0.99 * found) == check_failed);
  }
  for (const auto& [limit, found] : {std::pair(&Limits::min_ssim, pair["ssim"].get<double>()),
                                     std::pair(&Limits::min_psnr, pair["psnr"].get<double>())}) {
    CHECK(code(limit, found) == done);
    CHECK(code(limit, 1.01 * found) == check_failed);
  }
  const auto broken = result_in(folder)["pairs"][2]["broken_limits"];
  REQUIRE(broken.size() == 1);
  CHECK_THAT(broken[0].get<std::string>(), Contains("PSNR is") && Contains("dB accepted"));
}

TEST_CASE("a video is compared with the frames it was made of, and runs by their frames") {
  const TemporaryFolder folder;
  write_waves(folder / "a" / "frames", 3);
  write_waves(folder / "b" / "frames", 3);
  output::write_file(folder / "a" / "run.json",
                     R"({"scene": {"x": {"y": [{"z": 1}, 2]}, "w": 1}})");
  output::write_file(folder / "b" / "run.json",
                     R"({"scene": {"x": {"y": [{"z": 3}, 2]}, "v": 1}})");
  {
    output::VideoWriter writer(folder / "v.mp4", {.width = 64, .height = 36, .quality = 4});
    for (int k = 0; k < 3; ++k)
      writer.add(waves(64, 36, 0.1 * k));
  }
  CompareOptions options = options_for(folder / "v.mp4", folder / "a", folder);
  options.limits.min_psnr = 35;
  CHECK(run_compare(options) == done);
  options = options_for(folder / "a", folder / "b", folder);
  options.limits.max_flip = 0;
  CHECK(run_compare(options) == done);
  CHECK(result_in(folder)["notes"] ==
        nlohmann::json{"x.y[0].z: 1 and 3", "w: 1 and null", "v: null and 1"});
}

TEST_CASE("the report shows the worst pairs, as many as asked for") {
  const TemporaryFolder folder;
  write_waves(folder / "a", 5);
  write_waves(folder / "b", 5, 0.05);
  output::write_png(folder / "b" / "0003.png", waves(64, 36, 2));
  CompareOptions options = options_for(folder / "a", folder / "b", folder);
  options.shown_pairs = 1;
  run_compare(options);
  const std::string page = content_of(folder / "out" / "compare.html");
  CHECK_THAT(page, Contains("<h3>0003.png</h3>") && !Contains("<h3>0000.png</h3>"));
}

TEST_CASE("what can't be compared is refused with its name and its sizes") {
  const TemporaryFolder folder;
  write_waves(folder / "a", 3);
  write_waves(folder / "b", 2);
  fs::create_directories(folder / "empty");
  output::write_png(folder / "small.png", waves(32, 18, 0));
  std::ofstream(folder / "text.png") << "no picture";
  std::ofstream(folder / "glass.png", std::ios::binary)
      << one_row_png(PngColour::rgb_alpha, 8, 1, "\1\2\3\x80");
  std::ofstream(folder / "deep.png", std::ios::binary)
      << one_row_png(PngColour::rgb, 16, 1, "\1\2\3\4\5\6");
  const auto complaint = [&](const char* a, const char* b) {
    try {
      run_compare(options_for(folder / a, folder / b, folder));
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK_THAT(complaint("a", "b"), Contains("b: 0002.png is missing, which") && Contains("a has"));
  CHECK_THAT(complaint("b", "a"), Contains("b: 0002.png is missing"));
  CHECK_THAT(complaint("a/0000.png", "small.png"),
             Contains("64x36") && Contains("32x18") && Contains("small.png"));
  CHECK_THAT(complaint("a", "none"), Contains("none: there is no such file or folder"));
  CHECK_THAT(complaint("a", "empty"), Contains("empty: there are no PNG files"));
  CHECK_THAT(complaint("text.png", "small.png"), Contains("text.png") && Contains("not a PNG"));
  CHECK_THAT(complaint("a/0000.png", "a"), Contains("0000.png ends after 1 picture,"));
  CHECK_THAT(complaint("glass.png", "glass.png"), Contains("glass.png: it is transparent"));
  CHECK_THAT(complaint("deep.png", "deep.png"), Contains("deep.png: it has 16-bit samples"));
}

}  // namespace app_compare_tests
