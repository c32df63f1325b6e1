// A video's file, opened through libavformat.
#pragma once

#include <filesystem>
#include <memory>

#include "render/output/libav.hpp"

namespace spindrift::output {

/// Reads a container with what is in it. Nothing but the file itself is opened, whatever it names:
/// playlists are no videos.
class VideoInput {
 public:
  /// @param file a regular one
  /// @return an error of libav, below 0, or another number
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
