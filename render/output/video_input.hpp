// Opens video files through libavformat, for the readers of videos.
#pragma once

#include <filesystem>
#include <memory>

#include "render/output/libav.hpp"

namespace spindrift::output {

/// A video file that is open for reading. Nothing but the file itself is opened, whatever it names;
/// a playlist is not accepted as a video.
class VideoInput {
 public:
  /// @param file a regular file; opening a pipe would wait for a writer
  /// @return an error number of libav, which is below 0, or 0 or more on success
  int open(const std::filesystem::path& file);

  AVFormatContext* demuxer() const { return demuxer_.get(); }

 private:
  struct Close {
    void operator()(AVIOContext* p) const { avio_close(p); }
  };

  std::unique_ptr<AVIOContext, Close> bytes_;
  Owned<AVFormatContext> demuxer_;
};

}  // namespace spindrift::output
