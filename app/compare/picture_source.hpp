// Reads the pictures of a file, a folder, a video or a run, in order.
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
  std::string name;  ///< the file's name without its folder, or the picture's number in a video
  Image image;
};

/// Reads pictures one after the other, so that only one is in memory at a time.
class PictureSource {
 public:
  /// @param path a PNG, a video, a folder of PNGs, or a folder that `render` made, of which the
  /// frames are read
  /// @throws InputError when it is none of these
  explicit PictureSource(std::filesystem::path path);

  /// The next picture; none after the last.
  /// @throws InputError that names a file that can't be read
  std::optional<Picture> next();

  /// The path as it was given, for messages.
  const std::filesystem::path& path() const { return path_; }

  /// The sorted names of a folder's files, by which two folders are matched; empty for a single
  /// picture or a video.
  const std::vector<std::string>& names() const { return names_; }

 private:
  std::filesystem::path path_, folder_;
  std::vector<std::string> names_;
  std::unique_ptr<output::VideoReader> video_;
  std::size_t taken_ = 0;
};

/// Checks that two folders have pictures of the same names; other sources always pass.
/// @throws InputError that names a missing picture, and how many more are missing
void require_same_names(const PictureSource& a, const PictureSource& b);

}  // namespace spindrift::app
