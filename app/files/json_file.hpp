// Reads small JSON files that the program keeps for itself.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace spindrift::app {

/// The JSON in a file; null where the file is absent, not a regular file, not JSON, or nested
/// deeper than what the program writes.
nlohmann::ordered_json json_in(const std::filesystem::path& file);

/// The text that an object has under a name; empty where `json` is not an object, has no such name,
/// or has something other than text there.
std::string text_in(const nlohmann::ordered_json& json, const std::string& name);

}  // namespace spindrift::app
