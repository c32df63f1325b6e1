// Files in the manner of scenes: JSON into settings, by tables of their keys.
#pragma once

#include <filesystem>
#include <string>

namespace spindrift::app {

struct GoldenList;
class SceneDocument;

/// A file's text. @throws SceneError when it can't be read
std::string scene_text(const std::filesystem::path& file);

/// The whole document, by the section's table. @throws SceneError
void read_section(const SceneDocument& document, GoldenList& into);

}  // namespace spindrift::app
