// Tells how long a video is from what its file says, without decoding it.

#include <algorithm>
#include <limits>

#include "render/output/output.hpp"
#include "render/output/video_input.hpp"

namespace spindrift::output {

int video_length(const std::filesystem::path& file) {
  std::error_code none;
  if (!std::filesystem::is_regular_file(file, none))
    return 0;  // opening a pipe would wait for a writer
  av_log_set_level(AV_LOG_QUIET);
  VideoInput input;
  if (input.open(file) < 0)
    return 0;
  const AVFormatContext* demuxer = input.demuxer();
  std::int64_t frames = 0;
  for (unsigned k = 0; k < demuxer->nb_streams; ++k)
    if (demuxer->streams[k]->codecpar->codec_type == AVMEDIA_TYPE_VIDEO)
      frames = demuxer->streams[k]->nb_frames;
  constexpr std::int64_t most = std::numeric_limits<int>::max();
  return static_cast<int>(std::clamp<std::int64_t>(frames, 0, most));
}

}  // namespace spindrift::output
