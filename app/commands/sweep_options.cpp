#include "app/commands/sweep_options.hpp"

#include <limits>

#include "app/sweep/sweep_file.hpp"

namespace spindrift::app {

void add_sweep_options(CLI::App& command, TypedSweep& typed) {
  command.add_option("file", typed.file, "Scene file or sweep file")->required()->type_name("FILE");
  const auto add_several = [&](const char* name, auto& list, const char* about) {
    return command.add_option(name, list, about)->expected(1)->take_all();
  };
  add_several("--set", typed.values, "Values of one of the scene's keys; every combination runs")
      ->type_name("KEY=VALUE,VALUE,...");
  command
      .add_option("-o,--out", typed.output, "Folder for the results; out/<file>_sweep if left out")
      ->type_name("DIR");
  command
      .add_option("--reference", typed.reference,
                  "Run that all are compared with: its name, or values that it alone has")
      ->type_name("RUN");
  add_several("--target", typed.targets,
              "Rank runs by how close this figure of theirs comes to the number")
      ->type_name("METRIC=NUMBER");
  add_several("--times", typed.times, "When pictures are set side by side (s); five if left out")
      ->delimiter(',')
      ->type_name("SECONDS,...");
  command.add_option("--threads", typed.threads, "Threads of all runs together")
      ->type_name("N")
      ->check(CLI::Range(1, std::numeric_limits<int>::max()));
  command.add_option("--jobs", typed.jobs, "Runs at once, at most; as many as threads if left out")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  command.add_flag("--quiet", typed.quiet, "Print nothing but errors");
  command.add_flag("--json", typed.json, "Print for machines");
}

int run_typed_sweep(const TypedSweep& typed, const std::string& hint) {
  const std::filesystem::path file = typed.file;
  SweepRequest request = read_sweep_file(file).value_or(SweepRequest{.scene = file});
  for (const std::string& values : typed.values)
    request.axes.push_back(parse_sweep_axis(values));
  if (!typed.reference.empty())
    request.reference = typed.reference;
  for (const std::string& target : typed.targets)
    request.targets.push_back(parse_sweep_target(target));
  if (!typed.times.empty())
    request.times = typed.times;
  SweepOptions options;
  options.output = typed.output.empty()
                       ? std::filesystem::path("out") / (file.stem().string() + "_sweep")
                       : std::filesystem::path(typed.output);
  options.threads = typed.threads;
  options.jobs = typed.jobs;
  options.quiet = typed.quiet;
  options.json = typed.json;
  options.command_line_hint = hint;
  return run_sweep(request, options);
}

}  // namespace spindrift::app
