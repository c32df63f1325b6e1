#include "app/commands/common_options.hpp"

#include <fmt/format.h>

#include <limits>
#include <vector>

#include "app/scene/scene_fields.hpp"

namespace spindrift::app {

void add_common_options(CLI::App& command, TypedCommon& typed) {
  const std::vector<std::string> backends(value_names<sim::Backend>.begin(),
                                          value_names<sim::Backend>.end());
  command.add_option("--set", typed.overrides, "Set a scene's value, as in fluid.viscosity=0.05")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command.add_option("--threads", typed.threads, "Threads; all of the machine's if left out")
      ->type_name("N")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
  command
      .add_option("--backend", typed.backend,
                  fmt::format("What computes, as solver.backend: {}", fmt::join(backends, ", ")))
      ->type_name("NAME")
      ->check(CLI::IsMember(backends));
  command.add_flag("--quiet", typed.quiet, "Print nothing but errors");
  command.add_flag("--json", typed.json, "Print for machines");
}

Overrides all_overrides(const TypedCommon& typed) {
  Overrides all = typed.overrides;
  if (!typed.backend.empty())
    all.push_back("solver.backend=" + typed.backend);
  return all;
}

}  // namespace spindrift::app
