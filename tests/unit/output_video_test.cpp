extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}
#include <sched.h>
#include <sys/mman.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <memory>
#include <vector>

#include "output_support.hpp"
#include "render/output/output.hpp"

namespace output_video_tests {

using namespace spindrift;
using namespace spindrift::output_test;
using Catch::Matchers::Contains;

namespace {

struct Free {
  void operator()(AVCodecContext* p) const { avcodec_free_context(&p); }
  void operator()(AVFrame* p) const { av_frame_free(&p); }
  void operator()(AVPacket* p) const { av_packet_free(&p); }
  void operator()(AVFormatContext* p) const { avformat_close_input(&p); }
};
template <class T>
using Owned = std::unique_ptr<T, Free>;

struct Video {
  AVRational rate{};
  AVRational average_rate{};
  std::int64_t duration = 0;  // in units of time_base
  AVRational time_base{};
  std::int64_t file_duration = 0;  // µs
  std::int64_t indexed_frames = 0;
  AVCodecParameters parameters{};
  std::vector<double> times;  // s
  std::vector<Image> frames;
};

// BT.709 in limited range to full-range RGB (ITU-R BT.709-6, 3.2 and 3.5), by its definition.
Image to_rgb(const AVFrame& frame) {
  Image image(frame.width, frame.height);
  const auto byte = [](double value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(255.0 * value, 0.0, 255.0)));
  };
  std::size_t at = 0;
  for (int row = 0; row < frame.height; ++row) {
    for (int column = 0; column < frame.width; ++column) {
      const int chroma = row / 2 * frame.linesize[1] + column / 2;
      const double y = (frame.data[0][row * frame.linesize[0] + column] - 16) / 219.0;
      const double cb = (frame.data[1][chroma] - 128) / 224.0;
      const double cr = (frame.data[2][chroma] - 128) / 224.0;
      image.pixels[at++] = byte(y + 1.5748 * cr);
      image.pixels[at++] = byte(y - 0.2126 * 1.5748 / 0.7152 * cr - 0.0722 * 1.8556 / 0.7152 * cb);
      image.pixels[at++] = byte(y + 1.8556 * cb);
    }
  }
  return image;
}

void decode(AVCodecContext& decoder, const AVPacket* packet, Video& video) {
  REQUIRE(avcodec_send_packet(&decoder, packet) == 0);
  const Owned<AVFrame> frame(av_frame_alloc());
  while (avcodec_receive_frame(&decoder, frame.get()) == 0) {
    REQUIRE(frame->format == AV_PIX_FMT_YUV420P);
    REQUIRE(frame->colorspace == AVCOL_SPC_BT709);
    REQUIRE(frame->color_range == AVCOL_RANGE_MPEG);
    video.times.push_back(double(frame->best_effort_timestamp) * av_q2d(video.time_base));
    video.frames.push_back(to_rgb(*frame));
  }
}

Video read_video(const std::filesystem::path& file) {
  AVFormatContext* opened = nullptr;
  REQUIRE(avformat_open_input(&opened, file.c_str(), nullptr, nullptr) == 0);
  const Owned<AVFormatContext> format(opened);
  REQUIRE(avformat_find_stream_info(format.get(), nullptr) >= 0);
  REQUIRE(format->nb_streams == 1);
  const AVStream& stream = *format->streams[0];

  Video video;
  video.rate = stream.r_frame_rate;
  video.average_rate = stream.avg_frame_rate;
  video.duration = stream.duration;
  video.time_base = stream.time_base;
  video.file_duration = format->duration;
  video.indexed_frames = stream.nb_frames;
  video.parameters = *stream.codecpar;
  video.parameters.extradata = nullptr;  // goes away with the stream

  const AVCodec* codec = avcodec_find_decoder(stream.codecpar->codec_id);
  REQUIRE(codec != nullptr);
  const Owned<AVCodecContext> decoder(avcodec_alloc_context3(codec));
  REQUIRE(avcodec_parameters_to_context(decoder.get(), stream.codecpar) >= 0);
  REQUIRE(avcodec_open2(decoder.get(), codec, nullptr) == 0);
  const Owned<AVPacket> packet(av_packet_alloc());
  while (av_read_frame(format.get(), packet.get()) == 0) {
    decode(*decoder, packet.get(), video);
    av_packet_unref(packet.get());
  }
  decode(*decoder, nullptr, video);
  return video;
}

// Peak signal-to-noise ratio over all three channels, in dB.
double psnr(const Image& a, const Image& b) {
  REQUIRE(a.pixels.size() == b.pixels.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double difference = double(a.pixels[i]) - double(b.pixels[i]);
    sum += difference * difference;
  }
  return 10 * std::log10(255.0 * 255.0 * double(a.pixels.size()) / std::max(sum, 1e-9));
}

output::VideoSettings small_video() {
  output::VideoSettings settings;
  settings.width = 320;
  settings.height = 180;
  return settings;
}

void write_waves(const std::filesystem::path& file, const output::VideoSettings& settings,
                 int frames) {
  output::VideoWriter writer(file, settings);
  for (int i = 0; i < frames; ++i) {
    writer.add(waves(
        settings.width, settings.height,
        double(i) * settings.frames_per_second.denominator / settings.frames_per_second.numerator));
  }
  writer.finish();
}

// Names of the boxes of an MP4 file at its top level, in order.
std::vector<std::string> boxes(const std::filesystem::path& file) {
  const std::string all = content_of(file);
  std::vector<std::string> names;
  for (std::size_t at = 0; at + 8 <= all.size();) {
    std::size_t size = 0;
    for (std::size_t i = 0; i < 4; ++i)
      size = size << 8 | static_cast<unsigned char>(all[at + i]);
    REQUIRE(size >= 8);
    names.push_back(all.substr(at + 4, 4));
    at += size;
  }
  return names;
}

}  // namespace

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

}  // namespace output_video_tests
