// What a run is asked for, besides its scene.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace spindrift::app {

/// Frame numbers from 0, both ends included.
struct FrameRange {
  int first = 0;
  int last = 0;
};

/// How a run says how far it is.
enum class ProgressKind {
  text,  ///< a line that changes on a terminal; lines now and then elsewhere
  json   ///< a line for machines for each frame
};

struct RenderOptions {
  std::filesystem::path output;                         ///< folder of all results
  std::string scene_file;                               ///< absolute; empty: not known
  std::optional<FrameRange> frames;                     ///< none: all
  std::optional<std::filesystem::path> from_particles;  ///< folder of exported particles to draw
  bool export_meshes = false;
  bool export_particles = false;
  bool replace = false;        ///< also the results of another scene
  bool force = false;          ///< also what may not fit into memory or on the disk
  bool cache = true;           ///< keep particles and use those kept
  bool simulate_only = false;  ///< no meshes, pictures or video
  int threads = 0;             ///< 0: as many as the machine has
  bool quiet = false;          ///< nothing but errors
  bool json = false;           ///< for machines
  ProgressKind progress = ProgressKind::text;
  std::string command_line_hint;  ///< the command as typed, to say how to go on
};

}  // namespace spindrift::app
