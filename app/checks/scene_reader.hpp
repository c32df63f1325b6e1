// Reads the text of scene files, and of the sweep and golden-picture files that are like them.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace spindrift::app {

/// The text of a file.
/// @throws SceneError when the file can't be read, or is longer than 32 MB
std::string scene_text(const std::filesystem::path& file);

/// The text of a stream, up to its end.
/// @param source name of the stream in messages
/// @throws SceneError when the text is longer than 32 MB
std::string scene_text(std::istream& stream, const std::string& source);

}  // namespace spindrift::app
