// Decodes videos to pictures through libav: libavformat reads the file, libavcodec decompresses,
// libswscale turns what comes out into RGB.

extern "C" {
#include <libavutil/pixdesc.h>
}

#include <algorithm>
#include <cstring>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "render/output/input_file.hpp"
#include "render/output/libav.hpp"
#include "render/output/output.hpp"
#include "render/output/video_input.hpp"

namespace spindrift::output {
namespace {

/// Returns the colour space of a frame. Where a video does not say it, high definition (720 rows or
/// more) is taken for BT.709, smaller pictures for BT.601.
int color_space_of(const AVFrame& frame) {
  if (frame.colorspace == AVCOL_SPC_UNSPECIFIED)
    return frame.height >= 720 ? SWS_CS_ITU709 : SWS_CS_ITU601;
  return frame.colorspace;
}

}  // namespace

struct VideoReader::Impl {
  explicit Impl(std::filesystem::path name)
      : file(std::move(name)), packet(owned(av_packet_alloc())) {
    av_log_set_level(AV_LOG_QUIET);  // exceptions say what goes wrong
    open_file();
    open_decoder();
  }

  [[noreturn]] void fail(const std::string& why) const {
    throw std::runtime_error("cannot read " + file.string() + " as a video: " + why);
  }

  int check(int result) const {
    if (result < 0)
      fail(reason(result));
    return result;
  }

  void open_file() {
    require_regular_file(file);
    check(input.open(file));
    find_streams();
  }

  /// Finds out what the file holds. Some containers do not say it at their beginning; then pictures
  /// are decoded here, so that their size is limited here too.
  void find_streams() {
    std::vector<AVDictionary*> options(input.demuxer()->nb_streams);
    for (AVDictionary*& of_stream : options)
      av_dict_set_int(&of_stream, "max_pixels", most_pixels, 0);
    const int result = avformat_find_stream_info(input.demuxer(), options.data());
    for (AVDictionary*& of_stream : options)
      av_dict_free(&of_stream);
    check(result);
  }

  void open_decoder() {
    const AVCodec* codec = nullptr;
    stream = check(av_find_best_stream(input.demuxer(), AVMEDIA_TYPE_VIDEO, -1, -1, &codec, 0));
    decoder = owned(avcodec_alloc_context3(codec));
    check(avcodec_parameters_to_context(decoder.get(), input.demuxer()->streams[stream]->codecpar));
    decoder->max_pixels = most_pixels;
    check(avcodec_open2(decoder.get(), codec, nullptr));
  }

  /// Gives the decoder the next piece of the video, or its end.
  void feed() {
    for (;;) {
      const int result = av_read_frame(input.demuxer(), packet.get());
      if (result == AVERROR_EOF) {
        check(avcodec_send_packet(decoder.get(), nullptr));
        return;
      }
      check(result);
      const bool pictures = packet->stream_index == stream;
      const int sent = pictures ? avcodec_send_packet(decoder.get(), packet.get()) : 0;
      av_packet_unref(packet.get());
      if (pictures) {
        check(sent);
        return;
      }
    }
  }

  std::optional<Image> next() {
    const Owned<AVFrame> frame = owned(av_frame_alloc());
    for (;;) {
      const int result = avcodec_receive_frame(decoder.get(), frame.get());
      if (result == AVERROR_EOF)
        return std::nullopt;
      if (result != AVERROR(EAGAIN)) {
        check(result);
        return to_rgb(*frame);
      }
      feed();
    }
  }

  Image to_rgb(const AVFrame& frame) {
    if (frame.width <= 0 || frame.height <= 0 ||
        std::size_t(frame.width) * std::size_t(frame.height) > most_pixels)
      fail("a picture without pixels, or with too many");
    const AVPixFmtDescriptor* format = av_pix_fmt_desc_get(AVPixelFormat(frame.format));
    if (format == nullptr)
      fail("unknown pixel format");
    if (std::any_of(format->comp, format->comp + format->nb_components,
                    [](const AVComponentDescriptor& samples) { return samples.depth > 8; }))
      fail("it has more than 8 bits a sample; accepted: 8 bits");
    const bool alpha = (format->flags & AV_PIX_FMT_FLAG_ALPHA) != 0;
    const Owned<AVFrame> converted = convert(frame, alpha ? AV_PIX_FMT_RGBA : AV_PIX_FMT_RGB24);
    Image image(frame.width, frame.height);
    const int samples = alpha ? 4 : 3;
    std::size_t at = 0;
    for (int y = 0; y < image.height; ++y) {
      const std::uint8_t* pixel = converted->data[0] + y * converted->linesize[0];
      for (int x = 0; x < image.width; ++x, pixel += samples, at += 3) {
        if (alpha && pixel[3] != 255)
          fail("it is transparent in places; accepted: opaque pictures");
        std::memcpy(&image.pixels[at], pixel, 3);
      }
    }
    return image;
  }

  Owned<AVFrame> convert(const AVFrame& frame, AVPixelFormat format) {
    constexpr int flags = SWS_BICUBIC | SWS_ACCURATE_RND | SWS_BITEXACT | SWS_FULL_CHR_H_INT;
    converter.reset(sws_getCachedContext(converter.release(), frame.width, frame.height,
                                         AVPixelFormat(frame.format), frame.width, frame.height,
                                         format, flags, nullptr, nullptr, nullptr));
    if (!converter)
      fail("its pixels can't be converted");
    constexpr int full = 1, one = 1 << 16;  // contrast and saturation, as fixed point
    sws_setColorspaceDetails(converter.get(), sws_getCoefficients(color_space_of(frame)),
                             frame.color_range == AVCOL_RANGE_JPEG,
                             sws_getCoefficients(SWS_CS_ITU709), full, 0, one, one);
    // The rows have room behind them, which libswscale may write into.
    Owned<AVFrame> converted = owned(av_frame_alloc());
    converted->format = format;
    converted->width = frame.width;
    converted->height = frame.height;
    check(av_frame_get_buffer(converted.get(), 0));
    check(sws_scale(converter.get(), frame.data, frame.linesize, 0, frame.height, converted->data,
                    converted->linesize));
    return converted;
  }

  std::filesystem::path file;
  VideoInput input;
  Owned<AVCodecContext> decoder;
  Owned<SwsContext> converter;
  Owned<AVPacket> packet;
  int stream = 0;
};

VideoReader::VideoReader(const std::filesystem::path& file) : impl_(std::make_unique<Impl>(file)) {}

VideoReader::~VideoReader() = default;

std::optional<Image> VideoReader::next() {
  return impl_->next();
}

}  // namespace spindrift::output
