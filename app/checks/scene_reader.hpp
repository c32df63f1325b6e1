// Files in the manner of scenes: JSON into settings, by tables of their keys.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace spindrift::app {

/// A file's text. @throws SceneError when it can't be read, or is longer than any scene
std::string scene_text(const std::filesystem::path& file);

/// The same of a stream, to its end. @param source names it in messages
std::string scene_text(std::istream& stream, const std::string& source);

}  // namespace spindrift::app
