#include "render/output/video_input.hpp"

#include <cerrno>
#include <string>

namespace spindrift::output {
namespace {

/// Containers that a video of its own comes in, and still pictures; playlists and the like, which
/// are made of other files, are none.
constexpr const char* containers =
    "mov,matroska,avi,mpegts,mpeg,mpegvideo,m4v,h264,hevc,av1,ivf,flv,ogg,asf,mxf,nut,yuv4mpegpipe,"
    "gif,apng,jpeg_pipe,png_pipe,bmp_pipe,tiff_pipe,webp_pipe,ppm_pipe";

/// For what a container names: no file is opened but the video's.
int open_nothing(AVFormatContext*, AVIOContext**, const char*, int, AVDictionary**) {
  return AVERROR(EPERM);
}

}  // namespace

int VideoInput::open(const std::filesystem::path& file) {
  // "file:" lest a colon in the path be read as a protocol.
  const std::string url = "file:" + file.string();
  AVIOContext* bytes = nullptr;
  const int result = avio_open(&bytes, url.c_str(), AVIO_FLAG_READ);
  if (result < 0)
    return result;
  bytes_.reset(bytes);
  AVFormatContext* opened = owned(avformat_alloc_context()).release();
  opened->pb = bytes_.get();
  opened->io_open = open_nothing;
  AVDictionary* options = nullptr;
  av_dict_set(&options, "format_whitelist", containers, 0);
  const int found = avformat_open_input(&opened, url.c_str(), nullptr, &options);  // frees on error
  av_dict_free(&options);
  demuxer_.reset(opened);
  return found;
}

}  // namespace spindrift::output
