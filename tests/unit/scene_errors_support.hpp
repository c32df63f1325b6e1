// What the tests of error messages share.
#pragma once

#include <string>

#include "app/scene/scene.hpp"

namespace spindrift::app {

/// The message for a bad scene; empty if it is accepted.
inline std::string complaint(const std::string& text, const Overrides& overrides = {}) {
  try {
    parse_scene(text, "bad.json", overrides);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

}  // namespace spindrift::app
