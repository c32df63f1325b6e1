// Small JSON files that the program keeps for itself.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace spindrift::app {

/// JSON of a file; null where there is none, it is not a regular file, or it is not JSON
/// or nested deeper than what the program writes.
nlohmann::ordered_json json_in(const std::filesystem::path& file);

/// The text that an object has by a name; empty where it is no object, or has none or no text by
/// it.
std::string text_in(const nlohmann::ordered_json& json, const std::string& name);

}  // namespace spindrift::app
