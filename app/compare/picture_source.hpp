// The pictures of a file, a folder, a video or a run, in order.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/errors/errors.hpp"
#include "render/output/output.hpp"

namespace spindrift::app {

struct Picture {
  std::string name;  ///< the file's in its folder, or its number in the video
  Image image;
};

/// One picture at a time is in memory.
class PictureSource {
 public:
  /// @param path a PNG, a video, a folder of PNGs, or a folder that `render` made, whose frames are
  ///        meant. @throws InputError when it is none of these
  explicit PictureSource(std::filesystem::path path);

  /// The next picture; none after the last. @throws InputError naming the file
  std::optional<Picture> next();

  /// What was given, for messages.
  const std::filesystem::path& path() const { return path_; }

  /// A folder's files, by which two folders are matched; none for a picture or a video.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::filesystem::path path_, folder_;
  std::vector<std::string> names_;
  std::unique_ptr<output::VideoReader> video_;
  std::size_t taken_ = 0;
};

/// @throws InputError when two folders do not have the same pictures, naming those that are missing
void require_same_names(const PictureSource& a, const PictureSource& b);

}  // namespace spindrift::app
