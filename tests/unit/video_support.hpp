// What the tests of videos share: videos written, and decoded again by libav, with none of the
// program's reader.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
}
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "output_support.hpp"
#include "render/output/output.hpp"

namespace spindrift::output_test {

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

/// BT.709 in limited range to full-range RGB (ITU-R BT.709-6, 3.2 and 3.5), by its definition.
inline Image to_rgb(const AVFrame& frame) {
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

inline void decode(AVCodecContext& decoder, const AVPacket* packet, Video& video) {
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

inline Video read_video(const std::filesystem::path& file) {
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

/// Peak signal-to-noise ratio over all three channels, in dB.
inline double psnr(const Image& a, const Image& b) {
  REQUIRE(a.pixels.size() == b.pixels.size());
  double sum = 0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    const double difference = double(a.pixels[i]) - double(b.pixels[i]);
    sum += difference * difference;
  }
  return 10 * std::log10(255.0 * 255.0 * double(a.pixels.size()) / std::max(sum, 1e-9));
}

inline output::VideoSettings small_video() {
  output::VideoSettings settings;
  settings.width = 320;
  settings.height = 180;
  return settings;
}

inline void write_waves(const std::filesystem::path& file, const output::VideoSettings& settings,
                        int frames) {
  output::VideoWriter writer(file, settings);
  for (int i = 0; i < frames; ++i) {
    writer.add(waves(
        settings.width, settings.height,
        double(i) * settings.frames_per_second.denominator / settings.frames_per_second.numerator));
  }
  writer.finish();
}

/// Names of the boxes of an MP4 file at its top level, in order.
inline std::vector<std::string> boxes(const std::filesystem::path& file) {
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

}  // namespace spindrift::output_test
