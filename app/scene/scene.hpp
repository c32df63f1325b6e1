// A scene: the settings of every stage, read from a scene file and checked as a whole.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "app/errors/scene_error.hpp"
#include "app/scene/camera.hpp"
#include "render/frame_rate.hpp"
#include "render/gl/renderer.hpp"
#include "render/surface/surface.hpp"
#include "sim/core/settings.hpp"
#include "sim/run/probes.hpp"

namespace spindrift::app {

/// The pictures' size and number.
struct VideoConfig {
  int width = 1280;             ///< pixels, even
  int height = 720;             ///< pixels, even
  FrameRate frames_per_second;  ///< also how often the particles are kept
  double duration = 4.0;        ///< s
  int quality = 18;             ///< H.264 constant rate factor, 0 ... 51, less is better

  int frame_count() const { return frames_per_second.count_in(duration); }
};

struct Scene {
  std::string name;          ///< of the default output folder
  sim::Settings simulation;  ///< all that moves the liquid; nothing else below does
  std::vector<sim::Probe> probes;
  double probes_rate = 0.;  ///< readings of the probes per second, 1/s; 0: one for every picture
  surface::SurfaceSettings surface;
  CameraSettings camera;
  gl::LightSettings light;
  gl::LookSettings look;
  VideoConfig video;
};

/// One `--set KEY=VALUE` from the command line, as typed.
using Overrides = std::vector<std::string>;

/// Reads, completes and checks a scene file. @throws SceneError
Scene read_scene(const std::filesystem::path& file, const Overrides& overrides = {});

/// The same for text; `source` names it in messages, and its stem is the default scene name.
Scene parse_scene(std::string_view text, const std::filesystem::path& source,
                  const Overrides& overrides = {});

/// The resolved scene: every key, in the order of the tables, in the form of a scene file.
nlohmann::ordered_json to_json(const Scene& scene);

/// JSON schema (draft 7) of scene files.
nlohmann::ordered_json scene_schema();

/// 128 bits in hexadecimal of all that the particles of a scene depend on: the simulation's
/// settings, the times at which they are kept, and those at which probes are read. The name, the
/// camera, the look, the light and the video's size, quality and duration leave it as it is.
std::string simulation_hash(const Scene& scene);

/// 128 bits in hexadecimal of a text (FNV-1a).
std::string text_hash(std::string_view text);

}  // namespace spindrift::app
