#include "app/run/run_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

#include "app/cache/particle_cache.hpp"
#include "app/errors/errors.hpp"
#include "app/files/json_file.hpp"
#include "app/run/report.hpp"
#include "render/output/atomic_file.hpp"
#include "render/output/input_file.hpp"
#include "render/output/output.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// The folder of a run's pictures.
constexpr const char* picture_folder = "frames";

/// The parts of a run's folder besides run.json: pictures, videos, probes, and one for each export
/// format.
std::vector<std::string_view> parts() {
  std::vector<std::string_view> names{"pictures", "videos", "probes"};
  for (const ExportFormat& format : export_formats())
    names.push_back(format.folder);
  return names;
}

/// The folders in a run's folder that have a file for each frame.
std::vector<fs::path> frame_folders(const fs::path& run) {
  std::vector<fs::path> folders{run / picture_folder};
  for (const ExportFormat& format : export_formats())
    folders.push_back(run / format.folder);
  return folders;
}

/// A file of a run, and the range of frames that it shows, both ends included. `last` is -1 for a
/// file that belongs to the run as a whole.
struct RunFile {
  fs::path path;
  int first = 0;
  int last = -1;
};

/// The number that a text of four digits or more stands for; negative for any other text.
int number_of(std::string_view text) {
  int number = -1;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  return text.size() >= 4 && error == std::errc() && end == text.data() + text.size() ? number : -1;
}

/// A file with the frames that its name gives, as 0003.png or, with a prefix, video_0010-0020.mp4
/// do; nothing for other names.
std::optional<RunFile> numbered(const fs::path& path, std::string_view prefix) {
  const std::string stem = path.stem().string();
  if (!stem.starts_with(prefix))
    return std::nullopt;
  const std::string_view numbers = std::string_view(stem).substr(prefix.size());
  const auto dash = numbers.find('-');
  const int first = number_of(numbers.substr(0, dash));
  const int last = dash == std::string_view::npos ? first : number_of(numbers.substr(dash + 1));
  return first < 0 || last < 0 ? std::nullopt : std::optional(RunFile{path, first, last});
}

/// The files of a folder whose names give numbers of frames, in the order of these.
std::vector<RunFile> numbered_files(const fs::path& folder, std::string_view extension,
                                    std::string_view prefix = {}) {
  std::vector<RunFile> files;
  std::error_code none;  // a folder that isn't there has no files
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (entry.path().extension() == extension && entry.is_regular_file())
      if (const auto file = numbered(entry.path(), prefix))
        files.push_back(*file);
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, a.last) < std::pair(b.first, b.last);
  });
  return files;
}

std::vector<RunFile> videos_in(const fs::path& folder) {
  std::vector<RunFile> files = numbered_files(folder, ".mp4", "video_");
  const fs::path whole = folder / "video.mp4";
  if (fs::is_regular_file(whole))
    files.insert(files.begin(), {whole, 0, std::max(output::video_length(whole), 1) - 1});
  return files;
}

std::vector<RunFile> files_of(std::string_view part, const fs::path& folder) {
  if (part == "pictures")
    return numbered_files(folder / picture_folder, ".png");
  if (part == "videos")
    return videos_in(folder);
  for (const ExportFormat& format : export_formats())
    if (part == format.folder)
      return numbered_files(folder / format.folder, format.extension);
  std::vector<RunFile> files;
  for (const char* name : {"probes.csv", "probes.html"})
    if (fs::is_regular_file(folder / name))
      files.push_back({folder / name});
  return files;
}

/// For each part of the folder, a hash of all that its files depend on.
Json hashes_of_parts(const Scene& scene, const std::string& particles) {
  const Json whole = to_json(scene);
  Json look = whole;
  for (const char* key : {"name", "probes", "probes_rate"})
    look.erase(key);
  look["video"].erase("duration");
  look["video"].erase("quality");
  const std::string of = SPINDRIFT_VERSION + particles + simulation_hash(scene);
  const auto hash = [&](const auto&... values) { return text_hash((of + ... + values.dump())); };
  Json hashes;
  hashes["simulation"] = hash();
  hashes["pictures"] = hash(look);
  hashes["videos"] = hash(look, whole["video"]["quality"]);
  for (const ExportFormat& format : export_formats())
    hashes[std::string(format.folder)] = format.of_surface ? hash(whole["surface"]) : hash();
  hashes["probes"] = hash(whole["probes"], whole["probes_rate"]);
  return hashes;
}

/// The hash of the simulation from which a run takes its particles.
std::string particles_of(const Scene& scene, const RenderOptions& options) {
  return options.from_particles ? ParticleCache(*options.from_particles).simulation()
                                : simulation_hash(scene);
}

/// The numbers of the files' frames as ranges with both ends included, as in [[0, 2], [5, 9]].
Json ranges_of(const std::vector<RunFile>& files) {
  Json ranges = Json::array();
  for (const RunFile& file : files)
    if (!ranges.empty() && ranges.back()[1] == file.first - 1)
      ranges.back()[1] = file.first;
    else
      ranges.push_back({file.first, file.first});
  return ranges;
}

/// The list of frames in a run.json; empty where there is none, or where an entry is not as the
/// program writes it.
Json frames_in(const Json& run) {
  const auto is_ours = [](const Json& frame) {
    const auto has = [&](const char* key) {
      return frame.is_object() && frame.contains(key) && frame[key].is_number();
    };
    return has("steps") && has("rejected_steps") && has("iterations") && has("mean_compression") &&
           has("max_compression");
  };
  const Json frames = run.value("frames", Json());
  return frames.is_array() && std::all_of(frames.begin(), frames.end(), is_ours) ? frames
                                                                                 : Json::array();
}

std::ptrdiff_t lines_of(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

}  // namespace

RunFolder::RunFolder(const Scene& scene, const RenderOptions& options)
    : scene_(scene),
      options_(options),
      made_of_(hashes_of_parts(scene, particles_of(scene, options))),
      previous_(json_in(options.output / "run.json")) {
  if (!previous_.is_object())
    previous_ = Json();
  if (!options.replace)
    refuse_others();
}

void RunFolder::refuse_others() const {
  const fs::path& folder = options_.output;
  constexpr const char* advice = "give another folder by -o, or --force to replace them";
  if (!previous_.is_null()) {
    const std::string file = text_in(previous_, "scene_file");
    std::error_code ignored;  // a scene file that is gone has another name now
    if (!file.empty() && file != options_.scene_file && fs::exists(file, ignored))
      throw InputError(fmt::format("{} holds the results of another scene, {}; {}", folder.string(),
                                   file, advice));
    return;
  }
  if (fs::exists(folder / "run.json"))
    return;  // it is damaged, but a run wrote it
  for (const std::string_view part : parts())
    for (const RunFile& file : files_of(part, folder))
      throw InputError(fmt::format("{} is there, but no run.json that says of which scene; {}",
                                   file.path.string(), advice));
}

/// Whether the files that a part has from an earlier run are those of this scene.
bool RunFolder::belongs(std::string_view part) const {
  const std::string name(part);
  const Json made_of = previous_.is_null() ? Json() : previous_.value("made_of", Json());
  return text_in(made_of, name) == made_of_.at(name);
}

bool RunFolder::was_longer() const {
  return previous_.is_object() && previous_.contains("frames") &&
         previous_["frames"].size() > static_cast<std::size_t>(scene_.video.frame_count());
}

void RunFolder::remove_others() const {
  for (const std::string_view part : parts())
    for (const RunFile& file : files_of(part, options_.output))
      if (!belongs(part) || file.last >= scene_.video.frame_count())
        fs::remove(file.path);
  std::error_code not_empty;
  for (const fs::path& folder : frame_folders(options_.output))
    if (fs::is_directory(folder))
      fs::remove(folder, not_empty);
}

void RunFolder::begin() {
  for (const fs::path& folder : frame_folders(options_.output))
    output::remove_part_files(folder);
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(options_.output / "particles", none))
    output::remove_part_files(entry.path());
  if (!previous_.is_null()) {
    Json being_replaced = previous_;
    being_replaced["complete"] = false;
    for (const std::string_view part : parts())
      being_replaced.erase(std::string(part));
    write(being_replaced);
  }
  remove_others();
  Json json = identity();
  json["complete"] = false;
  if (!previous_.is_null() && belongs("simulation") && !was_longer())
    for (const char* key :
         {"particles", "boundary_particles", "simulation_bytes", "backend", "simulation_seconds",
          "simulation_phases", "steps", "rejected_steps", "iterations", "worst_mean_compression",
          "worst_max_compression", "frames"})
      if (previous_.contains(key))
        json[key] = previous_[key];
  write(json);
}

Json RunFolder::identity() const {
  Json json;
  json["name"] = scene_.name;
  json["command"] = options_.simulate_only ? "simulate" : "render";
  json["scene_file"] = options_.scene_file;
  json["complete"] = false;
  json["versions"] = versions_json();
  json["simulation_hash"] = simulation_hash(scene_);
  json["made_of"] = made_of_;
  json["scene"] = to_json(scene_);
  return json;
}

void RunFolder::write(const Json& json) const {
  output::write_file(options_.output / "run.json", json.dump(1) + "\n");
}

void RunFolder::write_probes(const RunRecord& record) const {
  if (scene_.probes.empty())
    return;
  const fs::path table = options_.output / "probes.csv";
  const std::string text = probes_csv(scene_, record.probe_readings);
  std::error_code none;
  if (belongs("probes") && !was_longer() && fs::is_regular_file(table, none) &&
      lines_of(output::read_file(table)) > lines_of(text))
    return;
  output::write_file(table, text);
  output::write_file(options_.output / "probes.html", probes_html(scene_, record.probe_readings));
}

/// Adds which frames the folder holds in each of its parts, and whether it is complete.
void RunFolder::add_contents(Json& json, const RunRecord& record) const {
  const fs::path& folder = options_.output;
  json["pictures"] = ranges_of(files_of("pictures", folder));
  json["videos"] = Json::array();
  for (const RunFile& file : files_of("videos", folder))
    json["videos"].push_back({{"file", file.path.filename().string()},
                              {"first_frame", file.first},
                              {"frames", output::video_length(file.path)}});
  for (const ExportFormat& format : export_formats())
    if (const auto files = files_of(format.folder, folder); !files.empty())
      json[std::string(format.folder)] = ranges_of(files);
  json["complete"] = is_complete(json, record);
}

/// Whether the command has left all that it should: the pictures and the video of the whole scene,
/// or its simulation to the end.
bool RunFolder::is_complete(const Json& json, const RunRecord& record) const {
  const int count = scene_.video.frame_count();
  if (options_.simulate_only)
    return static_cast<int>(record.frames.size()) == count &&
           record.frames_finished == record.frames_wanted;
  const auto& videos = json.at("videos");
  return json.at("pictures") == Json::array({{0, count - 1}}) && !videos.empty() &&
         videos[0].at("file") == "video.mp4" && videos[0].at("frames") == count;
}

Json RunFolder::finish(const RunRecord& record) {
  Json json = identity();
  const Json earlier =
      !previous_.is_null() && belongs("simulation") ? frames_in(previous_) : Json::array();
  json.update(report_json(scene_, record, earlier));
  add_contents(json, record);
  write(json);
  return json;
}

fs::path video_name(const RenderOptions& options, int first, int count, const VideoConfig& video) {
  const bool whole = !options.frames || (options.frames->first == 0 &&
                                         options.frames->last == video.frame_count() - 1);
  return whole ? "video.mp4" : fmt::format("video_{:04}-{:04}.mp4", first, first + count - 1);
}

}  // namespace spindrift::app
