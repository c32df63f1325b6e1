// Golden images, as a command.
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
  std::filesystem::path list;                   ///< file
  std::filesystem::path output = "out/golden";  ///< folder of what was rendered, and of the report
  std::vector<std::string> only;                ///< names; empty: all
  Overrides overrides;                          ///< of every scene
  bool quiet = false;                           ///< nothing but errors
  bool json = false;                            ///< for machines
};

/// Renders the scenes of a list and holds their frames against the pictures kept (check), or keeps
/// them (update). Fails where one is beyond its tolerance or has no picture. @throws SceneError,
/// InputError
int run_golden(const GoldenOptions& options);

}  // namespace spindrift::app
