// What a run leaves in its folder: the files of one scene, and run.json, which says of which.
//
// At each moment, whenever the process is killed, run.json tells the truth: files of another scene
// or look are removed while it still speaks for those, as not complete; then it is written for the
// new one, as not complete; only then are new files written.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/errors/errors.hpp"
#include "app/kept/run_options.hpp"
#include "app/run/run_record.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

class RunFolder {
 public:
  /// Changes nothing yet. The caller holds the folder's lock.
  /// @throws InputError where the folder holds what must not be replaced: the results of another
  /// scene file, or files that no run.json speaks for
  RunFolder(const Scene& scene, const RenderOptions& options);

  /// Removes what is not of this scene, and leaves a run.json that says that a run is under way.
  void begin();

  /// Leaves the probes' table and page, unless a table that goes on for longer is there.
  void write_probes(const RunRecord& record) const;

  /// Leaves the run.json of a run that ended, and returns it.
  nlohmann::ordered_json finish(const RunRecord& record);

 private:
  void refuse_others() const;
  bool belongs(std::string_view part) const;
  /// Whether the run before had more frames than this scene.
  bool was_longer() const;
  void remove_others() const;
  void write(const nlohmann::ordered_json& json) const;
  nlohmann::ordered_json identity() const;
  void add_contents(nlohmann::ordered_json& json, const RunRecord& record) const;
  bool is_complete(const nlohmann::ordered_json& json, const RunRecord& record) const;

  const Scene& scene_;
  const RenderOptions& options_;
  nlohmann::ordered_json made_of_;   ///< for each part, a hash of all that it depends on
  nlohmann::ordered_json previous_;  ///< run.json as it was found; null: none that can be used
};

/// Where the video of some frames belongs: video.mp4 for what begins a whole run, else a name with
/// the frames' numbers.
std::filesystem::path video_name(const RenderOptions& options, int first, int count,
                                 const VideoConfig& video);

}  // namespace spindrift::app
