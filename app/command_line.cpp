#include "app/command_line.hpp"

#include <fmt/core.h>
#include <fmt/format.h>
#include <omp.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "app/cache_options.hpp"
#include "app/commands.hpp"
#include "app/compare_options.hpp"
#include "app/machine_limits.hpp"
#include "app/nearest_name.hpp"
#include "app/scene_fields.hpp"
#include "app/scene_warnings.hpp"
#include "app/sweep_options.hpp"

namespace spindrift::app {
namespace {

/// All that can be typed; each command uses its part.
struct Typed {
  std::string scene;
  std::string output;
  std::string frames;
  std::string from_particles;
  std::vector<std::string> exports;
  Overrides overrides;
  std::string backend;
  int threads = 0;
  bool no_cache = false;
  bool force = false;
  std::string progress = "text";
  bool quiet = false;
  bool json = false;

  // bench; an empty list: the default one
  std::vector<std::string> scenes;
  std::vector<std::string> solvers;
  std::vector<double> spacing_factors, tolerance_factors, time_step_factors;
  std::vector<int> particle_counts;
  double limit_seconds = BenchPlan{}.limit_seconds;
  bool quick = false;
  bool plane = false, scaling = false, threads_scaling = false;

  bool of_sweeps = false;  // schema
};

/// What --set says, and options that stand for it.
Overrides all_overrides(const Typed& typed) {
  Overrides all = typed.overrides;
  if (!typed.backend.empty())
    all.push_back("solver.backend=" + typed.backend);
  return all;
}

/// Misuse of the command line; the message is for people.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

void add_common_options(CLI::App& command, Typed& typed) {
  const std::vector<std::string> backends(value_names<sim::Backend>.begin(),
                                          value_names<sim::Backend>.end());
  command.add_option("--set", typed.overrides, "Set a scene's value, as in fluid.viscosity=0.05")
      ->type_name("KEY=VALUE")
      ->expected(1)
      ->take_all();
  command.add_option("--threads", typed.threads, "Threads; all of the machine's if left out")
      ->type_name("N")
      ->check(CLI::Range(1, 4096));
  command
      .add_option("--backend", typed.backend,
                  fmt::format("What computes, as solver.backend: {}", fmt::join(backends, ", ")))
      ->type_name("NAME")
      ->check(CLI::IsMember(backends));
  command.add_flag("--quiet", typed.quiet, "Print nothing but errors");
  command.add_flag("--json", typed.json, "Print for machines");
}

void add_scene_options(CLI::App& command, Typed& typed) {
  command.add_option("scene", typed.scene, "Scene file")->required()->type_name("SCENE");
  add_common_options(command, typed);
}

void add_run_options(CLI::App& command, Typed& typed, const std::vector<std::string>& exports) {
  command.add_option("-o,--out", typed.output, "Folder for the results; out/<scene> if left out")
      ->type_name("DIR");
  command
      .add_option("--export", typed.exports,
                  fmt::format("Also write PLY files: {}", fmt::join(exports, ",")))
      ->type_name("WHAT")
      ->delimiter(',')
      ->expected(1)
      ->take_all()
      ->check(CLI::IsMember(exports));
  command.add_flag("--no-cache", typed.no_cache, "Simulate anew and keep no particles");
  command.add_flag("--force", typed.force,
                   "Also where another scene's results are replaced, or it may not fit");
  command
      .add_option("--progress", typed.progress,
                  "How far the run is, on stderr: text, or json for a line of JSON for each frame")
      ->type_name("FORM")
      ->check(CLI::IsMember({"text", "json"}));
}

/// An option that takes a list, as in --spacing 2,1.25.
template <class T>
CLI::Option* add_list(CLI::App& command, const char* name, std::vector<T>& list,
                      const std::string& about) {
  return command.add_option(name, list, about)->delimiter(',')->expected(1)->take_all();
}

void add_bench_options(CLI::App& command, Typed& typed) {
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

int parse_frame_number(const std::string& text, int if_empty) {
  if (text.empty()) {
    return if_empty;
  }
  const bool digits = text.size() < 9 && text.find_first_not_of("0123456789") == std::string::npos;
  return digits ? std::stoi(text) : -1;
}

/// "a:b" with either side left out for the first or last frame; "a" alone is that frame.
std::optional<FrameRange> parse_frames(const std::string& text, int frame_count) {
  if (text.empty()) {
    return std::nullopt;
  }
  const auto colon = text.find(':');
  const std::string first = text.substr(0, colon);
  const std::string last = colon == std::string::npos ? first : text.substr(colon + 1);
  const FrameRange range{parse_frame_number(first, 0), parse_frame_number(last, frame_count - 1)};
  if (range.first < 0 || range.first > range.last || range.last >= frame_count) {
    throw UsageError(
        fmt::format("--frames {}: expected FIRST:LAST within 0:{}", text, frame_count - 1));
  }
  return range;
}

std::string quoted(const std::string& word) {
  const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
    return word;
  }
  std::string result = "'";
  for (const char c : word) {
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return result + "'";
}

std::string command_as_typed(int argc, const char* const* argv) {
  std::vector<std::string> words;
  for (int i = 0; i < argc; ++i) {
    words.push_back(quoted(argv[i]));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

int run_typed_render(const Typed& typed, bool simulate_only, const std::string& hint) {
  const Scene scene = read_scene(typed.scene, all_overrides(typed));
  if (const std::string refused = sim::why_refused(scene.simulation); !refused.empty())
    throw UsageError(refused);
  const auto exports = [&](std::string_view what) {
    return std::find(typed.exports.begin(), typed.exports.end(), what) != typed.exports.end();
  };
  RenderOptions options;
  options.output = typed.output.empty() ? std::filesystem::path("out") / scene.name
                                        : std::filesystem::path(typed.output);
  std::error_code not_there;
  const auto file = std::filesystem::canonical(typed.scene, not_there);
  options.scene_file = not_there ? typed.scene : file.string();
  options.replace = typed.force || !typed.output.empty();
  options.force = typed.force;
  options.progress = typed.progress == "json" ? ProgressKind::json : ProgressKind::text;
  options.frames = parse_frames(typed.frames, scene.video.frame_count());
  if (!typed.from_particles.empty()) {
    if (!std::filesystem::is_directory(typed.from_particles)) {
      throw UsageError(
          fmt::format("--from-particles {}: there is no such folder", typed.from_particles));
    }
    options.from_particles = typed.from_particles;
  }
  options.export_meshes = exports("meshes");
  options.export_particles = exports("particles");
  options.cache = !typed.no_cache;
  options.simulate_only = simulate_only;
  options.threads = typed.threads;
  options.quiet = typed.quiet;
  options.json = typed.json;
  options.command_line_hint = hint;
  if (!typed.quiet && !options.from_particles) {
    print_warnings(scene);
  }
  return run_render(scene, options);
}

int run_typed_bench(const Typed& typed) {
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
  if (!typed.particle_counts.empty()) {
    plan.thread_scaling_particles = typed.particle_counts.back();
  }
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

/// The parser's complaint with the nearest valid name, where a name was mistyped.
std::string usage_message(CLI::App& app, const CLI::ParseError& error) {
  const auto* extras = dynamic_cast<const CLI::ExtrasError*>(&error);
  const auto unknown = app.remaining(true);
  if (!extras || unknown.empty()) {
    return error.what();
  }
  const std::string& word = unknown.front();
  std::vector<std::string_view> names;
  std::vector<std::string> storage;
  const auto chosen = app.get_subcommands();
  if (!word.starts_with("-") && chosen.empty()) {
    for (const CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
      if (!command->get_group().empty()) {
        storage.push_back(command->get_name());
      }
    }
    names.assign(storage.begin(), storage.end());
    return fmt::format("unknown command \"{}\"; {}", word, suggestion(word, names));
  }
  if (!word.starts_with("-")) {
    return fmt::format("\"{}\" is one word too many", word);
  }
  for (const CLI::Option* option : (chosen.empty() ? &app : chosen.front())->get_options()) {
    for (const std::string& name : option->get_lnames()) {
      storage.push_back("--" + name);
    }
  }
  names.assign(storage.begin(), storage.end());
  return fmt::format("unknown option {}; {}", word, suggestion(word, names));
}

int report(ExitCode code, const std::string& message) {
  std::fflush(stdout);
  fmt::print(stderr, "spindrift: {}\n", message);
  return code;
}

int run_parsed(CLI::App& app, int argc, const char* const* argv) {
  Typed typed;
  CLI::App* render = app.add_subcommand("render", "Simulate a scene and make its video");
  add_scene_options(*render, typed);
  add_run_options(*render, typed, {"meshes", "particles"});
  render->add_option("--frames", typed.frames, "Only these frames, from 0, both ends included")
      ->type_name("FIRST:LAST");
  render
      ->add_option("--from-particles", typed.from_particles,
                   "Draw the particles that a run kept in this folder (its particles/HASH); "
                   "nothing is simulated")
      ->type_name("DIR");

  CLI::App* simulate = app.add_subcommand("simulate", "Simulate a scene and keep its particles");
  add_scene_options(*simulate, typed);
  add_run_options(*simulate, typed, {"particles"});

  CLI::App* check = app.add_subcommand("check", "Check a scene; print it resolved, and its cost");
  add_scene_options(*check, typed);

  CLI::App* bench = app.add_subcommand("bench", "Measure speed, memory and errors");
  add_bench_options(*bench, typed);
  CLI::App* bench_run = app.add_subcommand("bench-run", "One run of bench, told on stdin");
  bench_run->group("");  // for bench itself

  CLI::App* sweep =
      app.add_subcommand("sweep", "Run a scene with many values, and compare the runs");
  TypedSweep typed_sweep;
  add_sweep_options(*sweep, typed_sweep);
  CLI::App* sweep_job = app.add_subcommand("sweep-job", "One task of sweep, told on stdin");
  sweep_job->group("");  // for sweep itself

  CLI::App* compare = app.add_subcommand("compare", "Compare pictures, videos or runs");
  CompareOptions compare_options;
  add_compare_options(*compare, compare_options);

  CLI::App* golden = app.add_subcommand("golden", "Hold scenes against pictures kept from before");
  GoldenOptions golden_options;
  add_golden_options(*golden, golden_options);

  CLI::App* cache = app.add_subcommand("cache", "List or remove kept simulations");
  TypedCache typed_cache;
  add_cache_options(*cache, typed_cache);

  CLI::App* info = app.add_subcommand("info", "Print versions, processor, renderer and encoder");
  info->add_flag("--json", typed.json, "Print for machines");

  CLI::App* schema = app.add_subcommand("schema", "Print the JSON schema of scene files");
  schema->group("");  // for the makers of scenes/scene.schema.json
  schema->add_flag("--sweep", typed.of_sweeps, "That of sweep files");

  app.parse(argc, argv);
  if (typed.threads == 0) {
    typed.threads = omp_get_max_threads();
  }
  if (render->parsed() || simulate->parsed()) {
    return run_typed_render(typed, simulate->parsed(), command_as_typed(argc, argv));
  }
  if (check->parsed()) {
    return run_check(read_scene(typed.scene, all_overrides(typed)), typed.threads, typed.quiet,
                     typed.json);
  }
  if (bench->parsed()) {
    return run_typed_bench(typed);
  }
  if (bench_run->parsed()) {
    return run_bench_child();
  }
  if (sweep->parsed()) {
    return run_typed_sweep(typed_sweep, command_as_typed(argc, argv));
  }
  if (sweep_job->parsed()) {
    return run_sweep_job();
  }
  if (compare->parsed()) {
    return run_compare(compare_options);
  }
  if (golden->parsed()) {
    return run_golden(golden_options);
  }
  if (cache->parsed()) {
    return run_typed_cache(typed_cache);
  }
  if (info->parsed()) {
    return run_info(typed.json);
  }
  if (schema->parsed()) {
    return run_schema(typed.of_sweeps);
  }
  throw UsageError("a command is missing");
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  CLI::App app{"Spindrift turns a liquid scene file into a video, with no display.", "spindrift"};
  app.set_version_flag("--version", "spindrift " SPINDRIFT_VERSION);
  app.require_subcommand(0, 1);
  app.footer("Scene files: scenes/*.json. Example: spindrift render scenes/dam_break.json");
  try {
    return run_parsed(app, argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {  // --help and --version
      return app.exit(error);
    }
    return report(bad_usage, usage_message(app, error) + " (see spindrift --help)");
  } catch (const UsageError& error) {
    return report(bad_usage, std::string(error.what()) + " (see spindrift --help)");
  } catch (const SceneError& error) {
    return report(bad_usage, error.what());
  } catch (const InputError& error) {
    return report(bad_usage, error.what());
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::broken_pipe) {
      return run_failed;  // who was to read it has heard enough
    }
    return report(run_failed, error.what());
  } catch (const std::exception& error) {
    return report(run_failed, reason_of(error));
  }
}

}  // namespace spindrift::app
