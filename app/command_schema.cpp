#include <fmt/core.h>

#include "app/commands.hpp"

namespace spindrift::app {

int run_schema() {
  fmt::print("{}", to_text(scene_schema()));
  return done;
}

}  // namespace spindrift::app
