// How long a video is, from what its file says, without decoding it.

#include "render/output/libav.hpp"
#include "render/output/output.hpp"

namespace spindrift::output {

int video_length(const std::filesystem::path& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none)) {
    return 0;  // opening a pipe would wait for a writer
  }
  const std::string url = "file:" + file.string();
  AVFormatContext* opened = nullptr;
  av_log_set_level(AV_LOG_FATAL);
  if (avformat_open_input(&opened, url.c_str(), nullptr, nullptr) < 0) {
    return 0;
  }
  const Owned<AVFormatContext> demuxer(opened);
  std::int64_t frames = 0;
  for (unsigned k = 0; k < demuxer->nb_streams; ++k) {
    if (demuxer->streams[k]->codecpar->codec_type == AVMEDIA_TYPE_VIDEO) {
      frames = demuxer->streams[k]->nb_frames;
    }
  }
  return static_cast<int>(frames);
}

}  // namespace spindrift::output
