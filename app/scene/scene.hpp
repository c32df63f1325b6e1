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
#include "render/gl/look/look.hpp"
#include "render/surface/surface.hpp"
#include "sim/core/settings.hpp"
#include "sim/run/probes.hpp"

namespace spindrift::app {

/// The size, rate and number of the pictures, and the quality of the video.
struct VideoConfig {
  int width = 1280;             ///< pixels, even
  int height = 720;             ///< pixels, even
  FrameRate frames_per_second;  ///< also the rate at which particles are written to the cache
  double duration = 4.0;        ///< s
  int quality = 18;             ///< H.264 constant rate factor, 0 ... 51; lower is better

  int frame_count() const { return frames_per_second.count_in(duration); }
};

/// The settings of every stage, from the simulation to the video.
struct Scene {
  std::string name;          ///< name of the default output folder
  sim::Settings simulation;  ///< all settings that the liquid's motion depends on
  std::vector<sim::Probe> probes;
  double probes_rate = 0.;  ///< readings of the probes per second, 1/s; 0: one for every picture
  surface::SurfaceSettings surface;
  CameraSettings camera;
  gl::LightSettings light;
  gl::LookSettings look;
  VideoConfig video;
};

/// The values of the `--set KEY=VALUE` options, each "KEY=VALUE" as typed.
using Overrides = std::vector<std::string>;

/// Reads a scene file, fills in defaults, loads its meshes and checks it as a whole.
/// @throws SceneError with everything that is wrong
Scene read_scene(const std::filesystem::path& file, const Overrides& overrides = {});

/// Reads a scene from text, as read_scene does from a file.
/// @param source names the text in messages; its stem is the default name of the scene, and mesh
/// files are looked for in its folder
/// @throws SceneError with everything that is wrong
Scene parse_scene(std::string_view text, const std::filesystem::path& source,
                  const Overrides& overrides = {});

/// The resolved scene in the form of a scene file, with every key in the order of the tables of
/// scene_fields.hpp.
nlohmann::ordered_json to_json(const Scene& scene);

/// JSON schema (draft 7) of scene files.
nlohmann::ordered_json scene_schema();

/// Hash, 128 bits in hexadecimal, of all that the particles of a scene depend on: the simulation's
/// settings, the times at which particles are written to the cache, and those at which probes are
/// read. The name, the camera, the look, the light and the video's size, quality and duration do
/// not change it.
std::string simulation_hash(const Scene& scene);

/// FNV-1a hash of a text, 128 bits in hexadecimal.
std::string text_hash(std::string_view text);

}  // namespace spindrift::app
