#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <set>
#include <vector>

#include "app/cache/simulation_record.hpp"
#include "app/commands/commands.hpp"
#include "app/errors/errors.hpp"
#include "app/files/folder_entries.hpp"
#include "app/files/json_file.hpp"
#include "app/resources/disk_estimate.hpp"
#include "app/system/machine_limits.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The particle cache of one simulation.
struct CachedSimulation {
  fs::path folder;    ///< folder of the particles, RUN/particles/HASH
  std::string scene;  ///< the scene's file, or its name where the file is unknown; may be empty
  int frames = 0;
  std::uint64_t bytes = 0;
  double age = 0;     ///< time since the last frame was written, s
  bool used = false;  ///< whether it is the simulation of the results in its run's folder

  /// The folder of the run.
  fs::path run() const { return fs::absolute(folder).parent_path().parent_path(); }
};

/// Seconds since a file was written.
double age_of(const fs::path& file) {
  std::error_code ignored;
  const auto written = fs::last_write_time(file, ignored);
  return std::chrono::duration<double>(fs::file_time_type::clock::now() - written).count();
}

CachedSimulation described(const fs::path& folder, std::vector<fs::path> frames) {
  CachedSimulation cached{.folder = folder,
                          .scene = {},
                          .frames = static_cast<int>(frames.size()),
                          .bytes = folder_bytes(folder),
                          .age = age_of(frames.front()),
                          .used = false};
  for (const fs::path& frame : frames)
    cached.age = std::min(cached.age, age_of(frame));
  const Json record = json_in(folder / simulation_record_file);
  const Json run = json_in(cached.run() / "run.json");
  cached.scene =
      text_in(record, text_in(record, "scene_file").empty() ? "scene_name" : "scene_file");
  cached.used = text_in(run, "simulation_hash") == folder.filename().string();
  return cached;
}

/// All particle caches below a folder, in the order of their paths.
std::vector<CachedSimulation> cached_below(const fs::path& root) {
  std::vector<fs::path> folders;
  std::error_code gone;
  for (const auto& entry : entries_below(root))
    if (entry.is_directory(gone) && entry.path().parent_path().filename() == "particles")
      folders.push_back(entry.path());
  std::sort(folders.begin(), folders.end());
  std::vector<CachedSimulation> found;
  for (const fs::path& folder : folders) {
    std::vector<fs::path> frames;
    for (const auto& entry : entries_in(folder))
      if (entry.is_regular_file(gone) && entry.path().extension() == ".particles" &&
          !entry.path().filename().string().starts_with("."))
        frames.push_back(entry.path());
    if (!frames.empty())
      found.push_back(described(folder, std::move(frames)));
  }
  return found;
}

std::string age_text(double seconds) {
  return seconds < 3600    ? fmt::format("{:.0f} min", seconds / 60)
         : seconds < 86400 ? fmt::format("{:.0f} h", seconds / 3600)
                           : fmt::format("{:.0f} d", seconds / 86400);
}

Json cached_json(const CachedSimulation& cached) {
  return {{"folder", cached.folder.string()}, {"scene", cached.scene},
          {"frames", cached.frames},          {"bytes", cached.bytes},
          {"age_seconds", cached.age},        {"used", cached.used}};
}

/// Removes a simulation's particles, unless a process is at work in its run's folder.
/// @return whether they are gone
bool remove(const CachedSimulation& cached) {
  try {
    const FolderLock lock(cached.run(), false);
    fs::remove_all(cached.folder);
    return true;
  } catch (const std::exception& error) {
    fmt::print(stderr, "spindrift: {} stays: {}\n", cached.folder.string(), error.what());
    return false;
  }
}

}  // namespace

int run_cache(const CacheOptions& options) {
  std::vector<CachedSimulation> chosen;
  std::set<fs::path> seen;  // a folder may be given by two names, or together with one above it
  for (const fs::path& folder : options.folders) {
    if (!fs::is_directory(folder))
      throw InputError(fmt::format("{}: there is no such folder", folder.string()));
    for (CachedSimulation& cached : cached_below(folder))
      if (seen.insert(fs::weakly_canonical(cached.folder)).second &&
          cached.age >= options.older_than && !(options.unused && cached.used))
        chosen.push_back(std::move(cached));
  }
  bool all_removed = true;
  double sum = 0;
  Json json = Json::array();
  for (const CachedSimulation& cached : chosen) {
    const bool removed = options.remove && remove(cached);
    all_removed = all_removed && removed;
    json.push_back(cached_json(cached));
    json.back()["removed"] = removed;
    if (!options.remove || removed)
      sum += static_cast<double>(cached.bytes);
    if (!options.quiet && !options.json)
      fmt::print("{:>8}  {:>5} frames  {:>7} old  {:<6}  {}  {}\n",
                 bytes_text(static_cast<double>(cached.bytes)), cached.frames, age_text(cached.age),
                 cached.used ? "used" : "unused", cached.folder.string(), cached.scene);
  }
  if (options.json)
    fmt::print("{}\n", json.dump(1));
  else if (!options.quiet)
    fmt::print("{} kept simulation{}, {}{}\n", chosen.size(), chosen.size() == 1 ? "" : "s",
               bytes_text(sum), options.remove ? " freed" : "");
  return options.remove && !all_removed ? run_failed : done;
}

}  // namespace spindrift::app
