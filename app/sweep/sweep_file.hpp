// Sweep files: a scene and what of it is varied, as JSON.
#pragma once

#include <optional>

#include "app/sweep/sweep_plan.hpp"

namespace spindrift::app {

/// Reads a file that is a sweep; nothing for one that is a scene. @throws SceneError for a file
/// that can't be read, and with line, column and JSON path for a sweep that is not right
std::optional<SweepRequest> read_sweep_file(const std::filesystem::path& file);

/// JSON schema (draft 7) of sweep files.
nlohmann::ordered_json sweep_schema();

}  // namespace spindrift::app
