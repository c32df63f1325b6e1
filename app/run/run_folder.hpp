// The output folder of a run: the files of one scene, and run.json, which says of which scene.
//
// At each moment, whenever the process is killed, run.json tells the truth: files of another scene
// or look are removed while run.json still names that one, as not complete; then run.json is
// written for the new scene, as not complete; only then are new files written.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/errors/errors.hpp"
#include "app/resources/run_options.hpp"
#include "app/run/run_record.hpp"
#include "app/scene/scene.hpp"

namespace spindrift::app {

/// Decides which files of earlier runs stay in the output folder, and writes run.json.
class RunFolder {
 public:
  /// Reads the run.json that is there, and changes nothing yet. The caller must hold the folder's
  /// lock.
  /// @param scene, options must outlive this object
  /// @throws InputError where the folder holds files that must not be replaced: the results of
  /// another scene file, or files without a run.json
  RunFolder(const Scene& scene, const RenderOptions& options);

  /// Removes unfinished files and those that are not of this scene, and writes a run.json that says
  /// that the run is not complete.
  void begin();

  /// Writes the probes' table and page, unless a longer table of the same probes is there.
  void write_probes(const RunRecord& record) const;

  /// Writes the run.json of a run that has ended, and returns its contents.
  nlohmann::ordered_json finish(const RunRecord& record);

 private:
  void refuse_others() const;
  bool belongs(std::string_view part) const;
  /// Whether the run that was here before had more frames than this scene.
  bool was_longer() const;
  void remove_others() const;
  void write(const nlohmann::ordered_json& json) const;
  nlohmann::ordered_json identity() const;
  void add_contents(nlohmann::ordered_json& json, const RunRecord& record) const;
  bool is_complete(const nlohmann::ordered_json& json, const RunRecord& record) const;

  const Scene& scene_;
  const RenderOptions& options_;
  nlohmann::ordered_json made_of_;   ///< for each part, a hash of all that its files depend on
  nlohmann::ordered_json previous_;  ///< run.json as it was found; null: it was missing or damaged
};

/// The name of the file of a video: video.mp4 where the options ask for all frames, else a name
/// with the numbers of the frames in it.
/// @param first the number of the video's first frame
/// @param count the number of its frames
std::filesystem::path video_name(const RenderOptions& options, int first, int count,
                                 const VideoConfig& video);

}  // namespace spindrift::app
