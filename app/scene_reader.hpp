// Files in the manner of scenes: JSON into settings, by tables of their keys.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

namespace spindrift::app {

struct GoldenList;
class SceneDocument;

/// A file's text. @throws SceneError when it can't be read, or is longer than any scene
std::string scene_text(const std::filesystem::path& file);

/// The same of a stream, to its end. @param source names it in messages
std::string scene_text(std::istream& stream, const std::string& source);

/// The whole document, by the section's table. @throws SceneError with all that is wrong in it
void read_section(const SceneDocument& document, GoldenList& into);

}  // namespace spindrift::app
