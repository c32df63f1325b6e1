#include "render/output/video_input.hpp"

#include <cerrno>
#include <string>

namespace spindrift::output {
namespace {

/// Formats that are accepted: containers that hold a whole video, and still pictures. Playlists and
/// the like, which are made of other files, are not among them.
constexpr const char* containers =
    "mov,matroska,avi,mpegts,mpeg,mpegvideo,m4v,h264,hevc,av1,ivf,flv,ogg,asf,mxf,nut,yuv4mpegpipe,"
    "gif,apng,jpeg_pipe,png_pipe,bmp_pipe,tiff_pipe,webp_pipe,ppm_pipe";

/// Refuses to open whatever a container names, so that no file is opened but the video's own.
int open_nothing(AVFormatContext*, AVIOContext**, const char*, int, AVDictionary**) {
  return AVERROR(EPERM);
}

}  // namespace

int VideoInput::open(const std::filesystem::path& file) {
  // The prefix "file:" keeps a colon in the path from being read as the end of a protocol.
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
  // On an error this frees `opened` and sets it to null.
  const int found = avformat_open_input(&opened, url.c_str(), nullptr, &options);
  av_dict_free(&options);
  demuxer_.reset(opened);
  return found;
}

}  // namespace spindrift::output
