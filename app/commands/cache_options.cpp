#include "app/commands/cache_options.hpp"

#include <fmt/format.h>

#include <charconv>

#include "app/commands/commands.hpp"
#include "app/errors/errors.hpp"

namespace spindrift::app {
namespace {

/// An age such as "30d", "12h" or "5min" in seconds.
double parse_age(const std::string& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const std::string_view unit(end, static_cast<std::size_t>(text.data() + text.size() - end));
  const double seconds = unit == "d" ? 86400 : unit == "h" ? 3600 : unit == "min" ? 60 : 0;
  if (error != std::errc() || seconds == 0 || !(number >= 0 && number < 1e6))
    throw InputError(fmt::format(
        "--older-than {}: expected days, hours or minutes, as in 30d, 12h, 5min", text));
  return number * seconds;
}

}  // namespace

void add_cache_options(CLI::App& command, TypedCache& typed) {
  command.add_option("folders", typed.folders, "Folders of runs, or above; out if left out")
      ->type_name("DIR");
  command.add_flag("--remove", typed.remove, "Remove them; a run simulates anew then");
  command.add_flag("--unused", typed.unused, "Only those that their folder's run does not use");
  command.add_option("--older-than", typed.older_than, "Only those older than that, as in 30d")
      ->type_name("AGE");
  command.add_flag("--quiet", typed.quiet, "Print nothing but errors");
  command.add_flag("--json", typed.json, "Print for machines");
}

int run_typed_cache(const TypedCache& typed) {
  CacheOptions options;
  options.folders.assign(typed.folders.begin(), typed.folders.end());
  if (options.folders.empty())
    options.folders = {"out"};
  options.remove = typed.remove;
  options.unused = typed.unused;
  options.older_than = typed.older_than.empty() ? 0 : parse_age(typed.older_than);
  options.quiet = typed.quiet;
  options.json = typed.json;
  return run_cache(options);
}

}  // namespace spindrift::app
