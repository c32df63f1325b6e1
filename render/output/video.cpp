// Writes H.264 in MP4 through libav: libswscale turns RGB into YUV, libavcodec (libx264)
// compresses, libavformat lays out the file.

extern "C" {
#include <libavutil/imgutils.h>
#include <libavutil/opt.h>
}

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "render/output/atomic_file.hpp"
#include "render/output/libav.hpp"
#include "render/output/output.hpp"
#include "render/shortage.hpp"

namespace spindrift::output {
namespace {

// Number of the encoder's threads. The encoded bytes depend on it, so it is fixed, whatever the
// machine has. Four let the encoder work beside the simulation of the next frame, and cost a single
// core 2 ms a frame.
constexpr int threads = 4;

// Time and size per frame, measured on 60 water-like frames of 1280x720 pixels at quality 18 with
// one core of a 2021 Xeon:
//   superfast  9 ms, 12.0 KiB a frame     faster  24 ms, 7.9 KiB a frame
//   veryfast  14 ms,  6.9 KiB a frame     medium  30 ms, 7.2 KiB a frame
constexpr const char* preset = "veryfast";

// Lowest constant rate factor in use. To libx264 a factor of 0 is another mode, in a profile (High
// 4:4:4 Predictive) that browsers do not play; the colours would have lost as much before, in the
// conversion to yuv420p.
constexpr int best_rate_factor = 1;

constexpr int seconds_between_key_frames = 2;  // after a jump a player decodes this much at most

void libav_check(int result, const std::filesystem::path& file, const char* doing) {
  if (result < 0) {
    throw std::runtime_error("cannot write " + file.string() + ": " + doing + ": " +
                             shortage().value_or(reason(result)));
  }
}

bool takes_yuv420p(const AVCodec& codec) {
  for (const AVPixelFormat* format = codec.pix_fmts; format && *format != AV_PIX_FMT_NONE; ++format)
    if (*format == AV_PIX_FMT_YUV420P)
      return true;
  return false;
}

// Returns libx264, or else any software encoder of H.264 (hardware ones differ from machine to
// machine), or null.
const AVCodec* find_encoder() {
  if (const AVCodec* x264 = avcodec_find_encoder_by_name("libx264"))
    return x264;
  void* position = nullptr;
  while (const AVCodec* codec = av_codec_iterate(&position)) {
    constexpr int hardware = AV_CODEC_CAP_HARDWARE | AV_CODEC_CAP_HYBRID;
    if (av_codec_is_encoder(codec) != 0 && codec->id == AV_CODEC_ID_H264 &&
        (codec->capabilities & hardware) == 0 && takes_yuv420p(*codec))
      return codec;
  }
  return nullptr;
}

constexpr const char* no_encoder =
    "this libavcodec has no H.264 encoder (Debian: install libavcodec59 or libavcodec-extra)";

const VideoSettings& validated(const VideoSettings& settings) {
  const auto reject = [](const std::string& what) {
    throw std::invalid_argument("VideoWriter: " + what);
  };
  const auto even = [](int size) { return size > 0 && size % 2 == 0; };
  if (!even(settings.width) || !even(settings.height)) {
    reject("width and height must be positive and even, not " + std::to_string(settings.width) +
           "x" + std::to_string(settings.height));
  }
  const FrameRate rate = settings.frames_per_second;
  if (rate.numerator <= 0 || rate.denominator <= 0 ||
      rate.numerator > std::int64_t{1000} * rate.denominator) {
    reject("frames per second must be more than 0 and at most 1000, not " +
           std::to_string(rate.numerator) + "/" + std::to_string(rate.denominator));
  }
  if (settings.quality < 0 || settings.quality > 51)
    reject("quality must be 0 to 51, not " + std::to_string(settings.quality));
  return settings;
}

Owned<AVCodecContext> open_encoder(const AVCodec& codec, const VideoSettings& settings,
                                   const std::filesystem::path& file) {
  Owned<AVCodecContext> encoder = owned(avcodec_alloc_context3(&codec));
  encoder->width = settings.width;
  encoder->height = settings.height;
  encoder->sample_aspect_ratio = {1, 1};
  encoder->pix_fmt = AV_PIX_FMT_YUV420P;
  encoder->color_primaries = AVCOL_PRI_BT709;
  encoder->color_trc = AVCOL_TRC_BT709;
  encoder->colorspace = AVCOL_SPC_BT709;
  encoder->color_range = AVCOL_RANGE_MPEG;
  encoder->chroma_sample_location = AVCHROMA_LOC_LEFT;
  const FrameRate rate = settings.frames_per_second;
  encoder->framerate = {rate.numerator, rate.denominator};
  encoder->time_base = {rate.denominator, rate.numerator};
  encoder->gop_size = std::max(1, seconds_between_key_frames * rate.numerator / rate.denominator);
  encoder->thread_count = threads;
  // No version strings are written, and the header comes once, in front, as MP4 wants it.
  encoder->flags |= AV_CODEC_FLAG_BITEXACT | AV_CODEC_FLAG_GLOBAL_HEADER;
  if (std::string(codec.name) == "libx264") {
    av_opt_set(encoder->priv_data, "preset", preset, 0);
    av_opt_set_double(encoder->priv_data, "crf", std::max(best_rate_factor, settings.quality), 0);
    // The encoder chooses the same algorithms on every CPU.
    av_opt_set(encoder->priv_data, "x264-params", "cpu-independent=1", 0);
  } else {
    encoder->qmin = settings.quality;
    encoder->qmax = settings.quality;
  }
  libav_check(avcodec_open2(encoder.get(), &codec, nullptr), file, "H.264 encoder");
  return encoder;
}

// Makes a frame with its rows aligned as libav's vectors want them, and with room behind the last
// one.
Owned<AVFrame> make_frame(AVPixelFormat format, int width, int height) {
  Owned<AVFrame> frame = owned(av_frame_alloc());
  frame->format = format;
  frame->width = width;
  frame->height = height;
  if (av_frame_get_buffer(frame.get(), 0) < 0)
    throw std::bad_alloc();
  return frame;
}

Owned<AVFrame> make_encoded_frame(const AVCodecContext& encoder) {
  Owned<AVFrame> frame = make_frame(encoder.pix_fmt, encoder.width, encoder.height);
  frame->color_primaries = encoder.color_primaries;
  frame->color_trc = encoder.color_trc;
  frame->colorspace = encoder.colorspace;
  frame->color_range = encoder.color_range;
  frame->chroma_location = encoder.chroma_sample_location;
  return frame;
}

// Makes a converter from sRGB values in full range to BT.709 in limited range. libswscale takes
// BT.601 unless told otherwise.
Owned<SwsContext> make_converter(int width, int height) {
  constexpr int flags = SWS_BICUBIC | SWS_ACCURATE_RND | SWS_BITEXACT | SWS_FULL_CHR_H_INP;
  Owned<SwsContext> converter =
      owned(sws_getContext(width, height, AV_PIX_FMT_RGB24, width, height, AV_PIX_FMT_YUV420P,
                           flags, nullptr, nullptr, nullptr));
  const int* bt709 = sws_getCoefficients(SWS_CS_ITU709);
  constexpr int full = 1;
  constexpr int limited = 0;
  constexpr int one = 1 << 16;  // contrast and saturation, as fixed point
  sws_setColorspaceDetails(converter.get(), bt709, full, bt709, limited, 0, one, one);
  return converter;
}

enum class State { open, failed, finished };

}  // namespace

struct VideoWriter::Impl {
  Impl(const std::filesystem::path& name, const VideoSettings& settings);
  void open_muxer();
  void add(const Image& image);
  void encode(const AVFrame* next);
  void finish();
  // Throws for a call of libav that went wrong, in a sentence with the name of the file.
  void check(int result, const char* doing) const { libav_check(result, file.final_name(), doing); }

  VideoSettings settings;
  AtomicFile file;  // libav opens it by its temporary name
  Owned<AVCodecContext> encoder;
  Owned<SwsContext> converter;
  Owned<AVFrame> rgb;  // a copy of the picture: libswscale reads a few bytes past its rows' ends
  Owned<AVFrame> frame;
  Owned<AVPacket> packet;
  Owned<AVFormatContext> muxer;
  AVStream* stream = nullptr;  // owned by the muxer
  std::int64_t frames = 0;
  State state = State::open;
};

VideoWriter::Impl::Impl(const std::filesystem::path& name, const VideoSettings& s)
    : settings(validated(s)), file(name), packet(owned(av_packet_alloc())) {
  av_log_set_level(AV_LOG_FATAL);  // exceptions say what goes wrong
  const AVCodec* codec = find_encoder();
  if (codec == nullptr)
    throw std::runtime_error("cannot write " + name.string() + ": " + no_encoder);
  encoder = open_encoder(*codec, settings, name);
  converter = make_converter(settings.width, settings.height);
  rgb = make_frame(AV_PIX_FMT_RGB24, settings.width, settings.height);
  frame = make_encoded_frame(*encoder);
  open_muxer();
}

void VideoWriter::Impl::open_muxer() {
  // The prefix "file:" keeps a colon in the path from being read as the end of a protocol.
  const std::string url = "file:" + file.temporary_name().string();
  AVFormatContext* allocated = nullptr;
  check(avformat_alloc_output_context2(&allocated, nullptr, "mp4", url.c_str()), "MP4 format");
  muxer.reset(allocated);
  muxer->flags |= AVFMT_FLAG_BITEXACT;  // writes no dates and no version strings

  stream = avformat_new_stream(muxer.get(), nullptr);
  if (stream == nullptr)
    throw std::bad_alloc();
  stream->time_base = encoder->time_base;
  stream->avg_frame_rate = encoder->framerate;
  check(avcodec_parameters_from_context(stream->codecpar, encoder.get()), "MP4 stream");

  check(avio_open(&muxer->pb, url.c_str(), AVIO_FLAG_WRITE), "opening");
  AVDictionary* options = nullptr;
  av_dict_set(&options, "movflags", "+faststart", 0);
  // Milliseconds, the default unit of time, cannot express most durations.
  const FrameRate rate = settings.frames_per_second;
  av_dict_set_int(&options, "movie_timescale",
                  rate.denominator == 1 ? rate.numerator * 1000 : rate.numerator, 0);
  const int result = avformat_write_header(muxer.get(), &options);
  av_dict_free(&options);
  check(result, "MP4 header");
}

// Hands one frame to the encoder, or the end of the video (nullptr), and writes what comes out.
void VideoWriter::Impl::encode(const AVFrame* next) {
  check(avcodec_send_frame(encoder.get(), next), "encoding");
  for (;;) {
    const int result = avcodec_receive_packet(encoder.get(), packet.get());
    if (result == AVERROR(EAGAIN) || result == AVERROR_EOF)
      return;
    check(result, "encoding");
    packet->stream_index = stream->index;
    packet->duration = 1;
    av_packet_rescale_ts(packet.get(), encoder->time_base, stream->time_base);
    check(av_interleaved_write_frame(muxer.get(), packet.get()), "writing");
  }
}

void VideoWriter::Impl::add(const Image& image) {
  const int stride = 3 * settings.width;
  if (image.width != settings.width || image.height != settings.height ||
      image.pixels.size() != std::size_t(stride) * std::size_t(settings.height)) {
    throw std::invalid_argument("VideoWriter: a frame of " + std::to_string(image.width) + "x" +
                                std::to_string(image.height) + " pixels for a video of " +
                                std::to_string(settings.width) + "x" +
                                std::to_string(settings.height));
  }
  if (std::exchange(state, State::failed) != State::open)
    throw std::logic_error("VideoWriter: add after finish or after an error");
  check(av_frame_make_writable(frame.get()), "frame");
  av_image_copy_plane(rgb->data[0], rgb->linesize[0], image.pixels.data(), stride, stride,
                      settings.height);
  sws_scale(converter.get(), rgb->data, rgb->linesize, 0, settings.height, frame->data,
            frame->linesize);
  frame->pts = frames;
  encode(frame.get());
  ++frames;
  state = State::open;
}

void VideoWriter::Impl::finish() {
  if (state == State::finished)
    return;
  if (std::exchange(state, State::failed) == State::failed)
    throw std::logic_error("VideoWriter: finish after an error");
  if (frames == 0)
    throw std::logic_error("VideoWriter: finish without a frame");
  encode(nullptr);
  check(av_write_trailer(muxer.get()), "MP4 index");
  check(avio_closep(&muxer->pb), "closing");
  file.commit();
  state = State::finished;
}

VideoWriter::VideoWriter(const std::filesystem::path& file, const VideoSettings& settings)
    : impl_(std::make_unique<Impl>(file, settings)) {}

VideoWriter::~VideoWriter() {
  if (impl_->state == State::open && impl_->frames > 0) {
    try {
      impl_->finish();
    } catch (const std::exception&) {
      // A destructor has nobody to tell; the temporary file is removed.
    }
  }
}

void VideoWriter::add(const Image& image) {
  impl_->add(image);
}

void VideoWriter::finish() {
  impl_->finish();
}

std::string encoder_info() {
  const AVCodec* codec = find_encoder();
  const auto version = [](unsigned v) {
    return std::to_string(AV_VERSION_MAJOR(v)) + "." + std::to_string(AV_VERSION_MINOR(v)) + "." +
           std::to_string(AV_VERSION_MICRO(v));
  };
  return (codec != nullptr ? codec->name : "no H.264 encoder") + std::string(" (libavcodec ") +
         version(avcodec_version()) + ", libavformat " + version(avformat_version()) + ")";
}

}  // namespace spindrift::output
