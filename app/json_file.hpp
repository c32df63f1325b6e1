// Small JSON files that the program keeps for itself.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

namespace spindrift::app {

/// JSON of a file; null where there is none, it is not a regular file, or it is not JSON
/// or nested deeper than what the program writes.
nlohmann::ordered_json json_in(const std::filesystem::path& file);

}  // namespace spindrift::app
