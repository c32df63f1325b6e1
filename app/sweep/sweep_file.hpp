// Sweep files: JSON files that name a scene and the values of its keys that a sweep runs it with.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/scene/scene_fields.hpp"
#include "app/sweep/latin_hypercube.hpp"

namespace spindrift::app {

/// The contents of a sweep file; keys that the file leaves out are empty.
struct SweepFile {
  std::string scene;  ///< path of the scene file from the sweep file's folder
  SweepValues set;    ///< values of all runs
  std::vector<Keyed<NonEmpty<Placed<Json>>>> grid;  ///< lists of values; every combination runs
  NonEmpty<SweepValues> list;                       ///< rows of values; each row runs
  std::optional<LatinHypercube> latin_hypercube;    ///< ranges of values; each sample runs
  std::string reference;                            ///< as in SweepRequest
  std::vector<SweepTarget> targets;                 ///< as in SweepRequest
  NonEmpty<double> times;                           ///< as in SweepRequest, s
};

template <>
inline constexpr auto table<SweepFile> = std::tuple{
    Field{"scene",
          &SweepFile::scene,
          "the scene file, its path from the sweep file's folder",
          {},
          {},
          Presence::required},
    Field{"set", &SweepFile::set, "values of all runs, by key, as in \"video.duration\": 2"},
    Field{"grid", &SweepFile::grid, "lists of values by key; every combination runs"},
    Field{"list", &SweepFile::list, "values by key; one run for each entry"},
    Field{"latin_hypercube", &SweepFile::latin_hypercube,
          "values drawn so that each part of each range is met once"},
    Field{"reference", &SweepFile::reference,
          "the run that all are compared with: its name, or values of it alone"},
    Field{"targets", &SweepFile::targets,
          "values of figures that runs are ranked by their closeness to", any_number},
    Field{"times", &SweepFile::times,
          "when pictures are set side by side; five times, evenly spread, if left out", times,
          "s"}};

/// Reads a sweep file.
/// @return nothing for a file that is a scene
/// @throws SceneError for a file that can't be read, and with line, column and JSON path for a
/// sweep that is wrong
std::optional<SweepRequest> read_sweep_file(const std::filesystem::path& file);

/// The JSON schema (draft 7) of sweep files.
Json sweep_schema();

}  // namespace spindrift::app
