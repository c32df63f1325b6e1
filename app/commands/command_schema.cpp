#include <fmt/core.h>

#include "app/commands/commands.hpp"
#include "app/errors/errors.hpp"
#include "app/sweep/sweep_file.hpp"
#include "app/tables/values.hpp"

namespace spindrift::app {

int run_schema(bool of_sweeps) {
  fmt::print("{}", to_text(of_sweeps ? sweep_schema() : scene_schema()));
  return done;
}

}  // namespace spindrift::app
