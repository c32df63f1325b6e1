#include "app/commands/command_line.hpp"

#include <fmt/core.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "app/checks/scene_reader.hpp"
#include "app/checks/scene_warnings.hpp"
#include "app/commands/bench_options.hpp"
#include "app/commands/cache_options.hpp"
#include "app/commands/commands.hpp"
#include "app/commands/compare_options.hpp"
#include "app/commands/sweep_options.hpp"
#include "app/errors/error_report.hpp"
#include "app/errors/errors.hpp"
#include "app/errors/nearest_name.hpp"
#include "app/errors/shown_text.hpp"
#include "app/system/machine_limits.hpp"
#include "app/system/thread_count.hpp"

namespace spindrift::app {
namespace {

constexpr const char* version_text = "spindrift " SPINDRIFT_VERSION;

/// The typed options of all commands that have no type of their own for them. Each command uses
/// some of these.
struct Typed : TypedCommon {
  std::string scene;
  std::string output;
  std::string frames;
  std::string from_particles;
  std::vector<std::string> exports;
  bool no_cache = false;
  bool force = false;
  std::string progress = "text";
  bool of_sweeps = false;  // of the command `schema`
  std::string command;     // of the command `help`
};

void add_scene_options(CLI::App& command, Typed& typed) {
  command.add_option("scene", typed.scene, "Scene file; - reads the standard input")
      ->required()
      ->type_name("SCENE");
  add_common_options(command, typed);
}

/// @param draws whether the command makes the liquid's surface, so that it can be exported
void add_run_options(CLI::App& command, Typed& typed, bool draws) {
  std::vector<std::string> names, shown;
  for (const ExportFormat& format : export_formats())
    if (draws || !format.of_surface) {
      names.emplace_back(format.name);
      shown.push_back(fmt::format("{} ({})", format.name, format.about));
    }
  command.add_option("-o,--out", typed.output, "Folder for the results; out/<scene> if left out")
      ->type_name("DIR");
  command
      .add_option("--export", typed.exports,
                  fmt::format("Also leave of each frame: {}", fmt::join(shown, ", ")))
      ->type_name("WHAT")
      ->delimiter(',')
      ->expected(1)
      ->take_all()
      ->check(CLI::IsMember(names));
  command.add_flag("--no-cache", typed.no_cache, "Simulate anew and keep no particles");
  command.add_flag("--force", typed.force,
                   "Also where another scene's results are replaced, or it may not fit");
  command
      .add_option("--progress", typed.progress,
                  "How far the run is, on stderr: text, or json for a line of JSON for each frame")
      ->type_name("FORM")
      ->check(CLI::IsMember({"text", "json"}));
}

/// The number that a text is, `if_empty` for empty text, and -1 for any other.
int parse_frame_number(const std::string& text, int if_empty) {
  if (text.empty())
    return if_empty;
  const bool digits = text.size() < 9 && text.find_first_not_of("0123456789") == std::string::npos;
  return digits ? std::stoi(text) : -1;
}

/// The frames of "a:b", where an absent side stands for the first or the last frame, or of "a"
/// alone; none for empty text.
std::optional<FrameRange> parse_frames(const std::string& text, int frame_count) {
  if (text.empty())
    return std::nullopt;
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

std::string quoted_for_shell(const std::string& word) {
  const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos)
    return word;
  std::string result = "'";
  for (const char c : word)
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string command_as_typed(int argc, const char* const* argv) {
  std::vector<std::string> words;
  for (int i = 0; i < argc; ++i)
    words.push_back(quoted_for_shell(argv[i]));
  return fmt::format("{}", fmt::join(words, " "));
}

Scene typed_scene(const Typed& typed) {
  if (typed.scene != "-")
    return read_scene(typed.scene, all_overrides(typed));
  const std::filesystem::path source = "stdin";
  return parse_scene(scene_text(std::cin, source.string()), source, all_overrides(typed));
}

int run_typed_render(const Typed& typed, bool simulate_only, const std::string& hint) {
  const Scene scene = typed_scene(typed);
  if (const std::string refused = sim::why_refused(scene.simulation); !refused.empty())
    throw UsageError(refused);
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
  options.exports = exports_of(typed.exports);
  options.cache = !typed.no_cache;
  options.simulate_only = simulate_only;
  options.threads = typed.threads;
  options.quiet = typed.quiet;
  options.json = typed.json;
  options.command_line_hint = hint;
  if (!typed.quiet && !options.from_particles)
    print_warnings(scene);
  return run_render(scene, options);
}

/// The commands meant for people, without those that other commands run.
std::vector<const CLI::App*> commands_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* command) { return !command->get_group().empty(); });
}

[[noreturn]] void throw_unknown_command(const CLI::App& app, const std::string& word) {
  std::vector<std::string> names;
  for (const CLI::App* command : commands_of(app))
    names.push_back(command->get_name());
  throw UsageError(
      fmt::format("unknown command \"{}\"; {}", shown(word),
                  suggestion(word, std::vector<std::string_view>(names.begin(), names.end()))));
}

int run_help(const CLI::App& app, const std::string& command) {
  const auto commands = commands_of(app);
  const auto found = std::find_if(commands.begin(), commands.end(),
                                  [&](const CLI::App* one) { return one->get_name() == command; });
  if (!command.empty() && found == commands.end())
    throw_unknown_command(app, command);
  fmt::print("{}", command.empty() ? app.help() : (*found)->help(app.get_name()));
  return done;
}

/// The parser's error message, or one with the nearest valid name where a name was mistyped.
/// @throws UsageError for an unknown command
std::string usage_message(CLI::App& app, const CLI::ParseError& error) {
  const auto* extras = dynamic_cast<const CLI::ExtrasError*>(&error);
  const auto unknown = app.remaining(true);
  if (!extras || unknown.empty())
    return error.what();
  const std::string& word = unknown.front();
  const auto chosen = app.get_subcommands();
  if (!word.starts_with("-")) {
    if (chosen.empty())
      throw_unknown_command(app, word);
    return fmt::format("\"{}\" is one word too many", shown(word));
  }
  std::vector<std::string> names;
  for (const CLI::Option* option : (chosen.empty() ? &app : chosen.front())->get_options())
    for (const std::string& name : option->get_lnames())
      names.push_back("--" + name);
  return fmt::format("unknown option {}; {}", shown(word),
                     suggestion(word, std::vector<std::string_view>(names.begin(), names.end())));
}

int run_parsed(CLI::App& app, int argc, const char* const* argv) {
  Typed typed;
  CLI::App* render = app.add_subcommand("render", "Simulate a scene and make its video");
  add_scene_options(*render, typed);
  add_run_options(*render, typed, true);
  render->add_option("--frames", typed.frames, "Only these frames, from 0, both ends included")
      ->type_name("FIRST:LAST");
  render
      ->add_option("--from-particles", typed.from_particles,
                   "Draw the particles that a run kept in this folder (its particles/HASH); "
                   "nothing is simulated")
      ->type_name("DIR");

  CLI::App* simulate = app.add_subcommand("simulate", "Simulate a scene and keep its particles");
  add_scene_options(*simulate, typed);
  add_run_options(*simulate, typed, false);

  CLI::App* check = app.add_subcommand("check", "Check a scene; print it resolved, and its cost");
  add_scene_options(*check, typed);

  CLI::App* bench = app.add_subcommand("bench", "Measure speed, memory and errors");
  TypedBench typed_bench;
  add_bench_options(*bench, typed_bench);
  CLI::App* bench_run = app.add_subcommand("bench-run", "One run of bench, told on stdin");
  bench_run->group("");  // hidden from help, as only bench runs it

  CLI::App* sweep =
      app.add_subcommand("sweep", "Run a scene with many values, and compare the runs");
  TypedSweep typed_sweep;
  add_sweep_options(*sweep, typed_sweep);
  CLI::App* sweep_job = app.add_subcommand("sweep-job", "One task of sweep, told on stdin");
  sweep_job->group("");  // hidden from help, as only sweep runs it

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

  CLI::App* schema =
      app.add_subcommand("schema", "Print the JSON schema of scene files, or of sweeps");
  schema->add_flag("--sweep", typed.of_sweeps, "That of sweep files");

  CLI::App* help = app.add_subcommand("help", "Print this help, or that of a command");
  help->add_option("command", typed.command, "Command")->type_name("COMMAND");
  CLI::App* version = app.add_subcommand("version", "Print the program's version");

  app.parse(argc, argv);
  const bool quiet = typed.quiet || typed_bench.quiet || typed_sweep.quiet || golden_options.quiet;
  const auto set_threads = [&](const CLI::App* command, int& threads) {
    if (command->parsed())
      threads = thread_count(threads, quiet);
  };
  for (const CLI::App* command : {render, simulate, check, golden})
    set_threads(command, typed.threads);
  set_threads(bench, typed_bench.threads);
  set_threads(sweep, typed_sweep.threads);
  if (render->parsed() || simulate->parsed())
    return run_typed_render(typed, simulate->parsed(), command_as_typed(argc, argv));
  if (check->parsed())
    return run_check(typed_scene(typed), typed.threads, typed.quiet, typed.json);
  if (bench->parsed())
    return run_typed_bench(typed_bench);
  if (bench_run->parsed())
    return run_bench_child();
  if (sweep->parsed())
    return run_typed_sweep(typed_sweep, command_as_typed(argc, argv));
  if (sweep_job->parsed())
    return run_sweep_job();
  if (compare->parsed())
    return run_compare(compare_options);
  if (golden->parsed())
    return run_golden(golden_options);
  if (cache->parsed())
    return run_typed_cache(typed_cache);
  if (info->parsed())
    return run_info(typed.json);
  if (schema->parsed())
    return run_schema(typed.of_sweeps);
  if (help->parsed())
    return run_help(app, typed.command);
  if (version->parsed()) {
    fmt::print("{}\n", version_text);
    return done;
  }
  throw UsageError("a command is missing");
}

/// Whether --json was typed. It is looked for without the parser, for errors of parsing.
bool wants_json(int argc, const char* const* argv) {
  return std::find(argv, argv + argc, std::string_view("--json")) != argv + argc;
}

}  // namespace

int run_command_line(int argc, const char* const* argv) {
  CLI::App app{"Spindrift turns a liquid scene file into a video, with no display.", "spindrift"};
  app.set_version_flag("-V,--version", version_text);
  app.require_subcommand(0, 1);
  app.footer("Scene files: scenes/*.json. Example: spindrift render scenes/dam_break.json");
  const bool json = wants_json(argc, argv);
  try {
    try {
      return run_parsed(app, argc, argv);
    } catch (const CLI::ParseError& error) {
      if (error.get_exit_code() == 0)  // --help and --version
        return app.exit(error);
      throw UsageError(usage_message(app, error));
    }
  } catch (const UsageError& error) {
    return tell_error(bad_usage, std::string(error.what()) + " (see spindrift --help)", json);
  } catch (const SceneError& error) {
    return tell_error(error, json);
  } catch (const InputError& error) {
    return tell_error(bad_usage, error.what(), json);
  } catch (const std::system_error& error) {
    if (error.code() == std::errc::broken_pipe)
      return run_failed;  // the reader has closed the pipe and wants no message
    return tell_error(run_failed, error.what(), json);
  } catch (const std::exception& error) {
    return tell_error(run_failed, reason_of(error), json);
  }
}

}  // namespace spindrift::app
