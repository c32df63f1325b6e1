// The options of a run, which it has besides its scene.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "app/exports/export_format.hpp"

namespace spindrift::app {

/// A range of frame numbers, which count from 0. Both ends are included.
struct FrameRange {
  int first = 0;
  int last = 0;
};

/// The form in which a run reports its progress.
enum class ProgressKind {
  text,  ///< one line that is rewritten on a terminal; a line now and then elsewhere
  json   ///< one line of JSON for each frame
};

/// The options of the render command, some of which other commands set as well.
struct RenderOptions {
  std::filesystem::path output;                         ///< folder of all results
  std::string scene_file;                               ///< absolute path; empty where unknown
  std::optional<FrameRange> frames;                     ///< frames to draw; none: all
  std::optional<std::filesystem::path> from_particles;  ///< folder of exported particles to draw
  Exports exports;             ///< what is left of each frame besides its picture
  bool replace = false;        ///< replace results even of another scene
  bool force = false;          ///< run even if memory or disk space may not be enough
  bool cache = true;           ///< write the particle cache, and use what is in it
  bool simulate_only = false;  ///< make no meshes, pictures or video
  int threads = 0;             ///< 0: as many as the machine has
  bool quiet = false;          ///< print nothing but errors
  bool json = false;           ///< print results as JSON
  ProgressKind progress = ProgressKind::text;
  std::string command_line_hint;  ///< the command as typed, for the hint how to continue the run
};

}  // namespace spindrift::app
