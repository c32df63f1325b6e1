// The command `golden`, which renders scenes and compares their frames with reference pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/errors/errors.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

enum class GoldenAction { check, update };

struct GoldenOptions {
  GoldenAction action = GoldenAction::check;
  std::filesystem::path list;                   ///< file of the list of golden tests
  std::filesystem::path output = "out/golden";  ///< folder of the rendered frames and the report
  std::vector<std::string> only;                ///< names of the tests to run; empty: all
  Overrides overrides;                          ///< values to set in every scene
  bool quiet = false;                           ///< print nothing but errors
  bool json = false;                            ///< print results as JSON
};

/// Renders the scenes of a list, and compares their frames with the reference pictures (check) or
/// makes them the reference pictures (update).
/// @return the exit code: check_failed where a frame is beyond a limit or has no reference picture,
/// run_failed where a scene can't be rendered
/// @throws SceneError for a list or a scene that can't be used
/// @throws InputError for other input that can't be used
int run_golden(const GoldenOptions& options);

}  // namespace spindrift::app
