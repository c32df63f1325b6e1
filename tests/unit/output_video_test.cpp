// What a video shows and how long it lasts, read back from its file.
#include <sched.h>

#include <catch2/catch.hpp>
#include <vector>

#include "video_support.hpp"

namespace output_video_tests {

using namespace spindrift;
using namespace spindrift::output_test;
using Catch::Matchers::Contains;

TEST_CASE("A video has all its frames at a constant rate and lasts exactly frames / rate") {
  const TemporaryFolder folder;
  for (const int rate : {24, 30, 60}) {
    for (const int frames : {1, 2, 47}) {
      CAPTURE(rate, frames);
      output::VideoSettings settings = small_video();
      settings.frames_per_second = rate;
      write_waves(folder / "v.mp4", settings, frames);
      const Video video = read_video(folder / "v.mp4");
      REQUIRE(video.indexed_frames == frames);
      REQUIRE(video.frames.size() == std::size_t(frames));
      REQUIRE(av_cmp_q(video.average_rate, {rate, 1}) == 0);
      REQUIRE(video.duration * video.time_base.num * rate ==
              std::int64_t(frames) * video.time_base.den);
      REQUIRE(std::abs(double(video.file_duration) - 1e6 * frames / rate) <= 1.0);
      for (int i = 0; i < frames; ++i)
        REQUIRE(std::abs(video.times[std::size_t(i)] - double(i) / rate) < 1e-9);
    }
  }
}

TEST_CASE("A video is H.264 in yuv420p with square pixels and tagged BT.709") {
  const TemporaryFolder folder;
  write_waves(folder / "v.mp4", small_video(), 3);
  const AVCodecParameters p = read_video(folder / "v.mp4").parameters;
  REQUIRE(p.codec_id == AV_CODEC_ID_H264);
  REQUIRE(p.width == 320);
  REQUIRE(p.height == 180);
  REQUIRE(p.format == AV_PIX_FMT_YUV420P);
  REQUIRE(p.color_primaries == AVCOL_PRI_BT709);
  REQUIRE(p.color_trc == AVCOL_TRC_BT709);
  REQUIRE(p.color_space == AVCOL_SPC_BT709);
  REQUIRE(p.color_range == AVCOL_RANGE_MPEG);
  REQUIRE(p.sample_aspect_ratio.num == p.sample_aspect_ratio.den);
}

TEST_CASE("A video can start to play before it is fetched whole") {
  const TemporaryFolder folder;
  write_waves(folder / "v.mp4", small_video(), 5);
  const auto names = boxes(folder / "v.mp4");
  const auto moov = std::find(names.begin(), names.end(), "moov");
  const auto mdat = std::find(names.begin(), names.end(), "mdat");
  REQUIRE(names.front() == "ftyp");
  REQUIRE(moov != names.end());
  REQUIRE(mdat != names.end());
  REQUIRE(moov < mdat);
}

TEST_CASE("Frames of a video look like the originals") {
  const TemporaryFolder folder;
  const output::VideoSettings settings = small_video();
  write_waves(folder / "v.mp4", settings, 30);
  const Video video = read_video(folder / "v.mp4");
  REQUIRE(video.frames.size() == 30);
  for (int i = 0; i < 30; ++i) {
    CAPTURE(i);
    REQUIRE(psnr(video.frames[std::size_t(i)], waves(320, 180, i / 30.0)) > 35.0);
  }
}

TEST_CASE("Plain colours come back from a video as they were") {
  // Decoded as BT.709, a red that was encoded as BT.601 is off by more than 20 in a channel.
  const TemporaryFolder folder;
  const int colours[][3] = {{255, 0, 0}, {0, 255, 0},   {0, 0, 255},     {255, 255, 255},
                            {0, 0, 0},   {20, 90, 160}, {128, 128, 128}, {200, 40, 90}};
  for (const auto& c : colours) {
    CAPTURE(c[0], c[1], c[2]);
    {
      output::VideoWriter writer(folder / "v.mp4", small_video());
      for (int i = 0; i < 3; ++i)
        writer.add(solid(320, 180, c[0], c[1], c[2]));
      writer.finish();
    }
    for (const Image& frame : read_video(folder / "v.mp4").frames) {
      const std::size_t centre = (std::size_t(90) * 320 + 160) * 3;
      for (std::size_t channel = 0; channel < 3; ++channel)
        REQUIRE(std::abs(int(frame.pixels[centre + channel]) - c[channel]) <= 3);
    }
  }
}

TEST_CASE("A better quality is nearer to the originals and takes more space") {
  const TemporaryFolder folder;
  const auto measure = [&](int quality) {
    output::VideoSettings settings = small_video();
    settings.quality = quality;
    write_waves(folder / "v.mp4", settings, 10);
    return std::pair(psnr(read_video(folder / "v.mp4").frames[5], waves(320, 180, 5 / 30.0)),
                     std::filesystem::file_size(folder / "v.mp4"));
  };
  const auto good = measure(12);
  const auto bad = measure(40);
  REQUIRE(good.first > bad.first + 3);
  REQUIRE(good.second > bad.second);
}

TEST_CASE(
    "The best quality is a video for browsers as every other is, and nearly as the originals") {
  const TemporaryFolder folder;
  output::VideoSettings settings = small_video();
  settings.quality = 0;
  write_waves(folder / "v.mp4", settings, 10);
  const Video video = read_video(folder / "v.mp4");
  CHECK(video.parameters.profile == FF_PROFILE_H264_HIGH);
  CHECK(video.parameters.format == AV_PIX_FMT_YUV420P);
  REQUIRE(video.frames.size() == 10);
  for (int i = 0; i < 10; ++i)
    CHECK(psnr(video.frames[std::size_t(i)], waves(320, 180, i / 30.0)) > 42);
}

TEST_CASE("A rate may be a fraction, as NTSC's, and a video lasts exactly as long") {
  const TemporaryFolder folder;
  for (const FrameRate rate : {FrameRate(30000, 1001), {24000, 1001}, {1, 2}}) {
    CAPTURE(rate.numerator, rate.denominator);
    output::VideoSettings settings = small_video();
    settings.frames_per_second = rate;
    write_waves(folder / "v.mp4", settings, 47);
    const Video video = read_video(folder / "v.mp4");
    REQUIRE(video.frames.size() == 47);
    CHECK(av_cmp_q(video.average_rate, {rate.numerator, rate.denominator}) == 0);
    CHECK(video.duration * video.time_base.num * rate.numerator ==
          std::int64_t{47} * rate.denominator * video.time_base.den);
    CHECK(std::abs(video.times[46] - 46. * rate.denominator / rate.numerator) < 1e-9);
  }
}

TEST_CASE("The same frames give the same bytes, on one core too") {
  const TemporaryFolder folder;
  write_waves(folder / "a.mp4", small_video(), 40);
  write_waves(folder / "b.mp4", small_video(), 40);
  const std::string bytes = content_of(folder / "a.mp4");
  REQUIRE(bytes == content_of(folder / "b.mp4"));
  REQUIRE(bytes.find("Lavf") == std::string::npos);
  REQUIRE(bytes.find("Lavc") == std::string::npos);

  cpu_set_t before;
  REQUIRE(::sched_getaffinity(0, sizeof before, &before) == 0);
  int first = 0;
  while (!CPU_ISSET(first, &before))
    ++first;
  cpu_set_t one;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  REQUIRE(::sched_setaffinity(0, sizeof one, &one) == 0);
  write_waves(folder / "c.mp4", small_video(), 40);
  REQUIRE(::sched_setaffinity(0, sizeof before, &before) == 0);
  REQUIRE(bytes == content_of(folder / "c.mp4"));
}

}  // namespace output_video_tests
