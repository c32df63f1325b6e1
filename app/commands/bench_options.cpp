#include "app/commands/bench_options.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/errors/errors.hpp"
#include "app/scene/scene_fields.hpp"

namespace spindrift::app {
namespace {

/// Adds an option that takes a list, as in --spacing 2,1.25.
template <class T>
CLI::Option* add_list(CLI::App& command, const char* name, std::vector<T>& list,
                      const std::string& about) {
  return command.add_option(name, list, about)->delimiter(',')->expected(1)->take_all();
}

}  // namespace

void add_bench_options(CLI::App& command, TypedBench& typed) {
  command.add_option("scenes", typed.scenes, "Scene files of the plane; a dam break if left out")
      ->type_name("SCENE");
  add_common_options(command, typed);
  command.add_option("-o,--out", typed.output, "Folder for the results; out/bench if left out")
      ->type_name("DIR");
  command.add_flag("--quick", typed.quick, "Fewer and smaller runs, for a first look");
  command.add_flag("--plane", typed.plane, "Speed against error; this alone if nothing is chosen");
  command.add_flag("--scaling", typed.scaling, "Cost per particle of the dam break as it grows");
  command.add_flag("--threads-scaling", typed.threads_scaling, "The same for 1, 2, 4 ... threads");
  const std::vector<std::string> solvers(value_names<sim::SolverType>.begin(),
                                         value_names<sim::SolverType>.end());
  add_list(command, "--solver", typed.solvers, "Solvers of the plane")
      ->type_name("NAME,...")
      ->check(CLI::IsMember(solvers));
  const auto add_factors = [&](const char* name, std::vector<double>& factors, const char* of) {
    add_list(command, name, factors, fmt::format("Factors of the scene's {}", of))
        ->type_name("FACTOR,...")
        ->check(CLI::Range(1e-3, 1e3));
  };
  add_factors("--spacing", typed.spacing_factors, "fluid.spacing");
  add_factors("--tolerance", typed.tolerance_factors,
              "solver.mean_compression and solver.max_compression (sph: of its compressibility)");
  add_factors("--time-step", typed.time_step_factors, "solver.cfl and solver.max_time_step");
  add_list(command, "--particles", typed.particle_counts,
           "Particles of the scalings, about; threads share the last")
      ->type_name("N,...")
      ->check(CLI::Range(1, 100'000'000));
  command.add_option("--limit", typed.limit_seconds, "Seconds after which a run is given up")
      ->type_name("SECONDS")
      ->check(CLI::Range(0.01, 1e6))
      ->capture_default_str();
}

int run_typed_bench(const TypedBench& typed) {
  const bool chosen = typed.plane || typed.scaling || typed.threads_scaling;
  if (chosen && !typed.plane && !typed.scenes.empty())
    throw UsageError(
        fmt::format("{}: --scaling and --threads-scaling run a dam break of their own; leave the "
                    "scene out, or add --plane",
                    typed.scenes.front()));
  BenchOptions options;
  BenchPlan& plan = options.plan;
  plan = default_plan(typed.quick);
  plan.scenes.assign(typed.scenes.begin(), typed.scenes.end());
  plan.overrides = all_overrides(typed);
  plan.plane = typed.plane || !chosen;
  plan.particle_scaling = typed.scaling;
  plan.thread_scaling = typed.threads_scaling;
  plan.threads = typed.threads;
  plan.limit_seconds = typed.limit_seconds;
  const auto replace = [](auto& list, const auto& by) {
    if (!by.empty())
      list = by;
  };
  replace(plan.spacing_factors, typed.spacing_factors);
  replace(plan.tolerance_factors, typed.tolerance_factors);
  replace(plan.time_step_factors, typed.time_step_factors);
  replace(plan.particle_counts, typed.particle_counts);
  if (!typed.particle_counts.empty())
    plan.thread_scaling_particles = typed.particle_counts.back();
  std::vector<sim::SolverType> solvers;
  for (const std::string& name : typed.solvers) {
    const auto& names = value_names<sim::SolverType>;
    solvers.push_back(
        static_cast<sim::SolverType>(std::find(names.begin(), names.end(), name) - names.begin()));
  }
  replace(plan.solvers, solvers);
  options.output = typed.output.empty() ? "out/bench" : typed.output;
  options.quiet = typed.quiet;
  options.json = typed.json;
  return run_bench(options);
}

}  // namespace spindrift::app
