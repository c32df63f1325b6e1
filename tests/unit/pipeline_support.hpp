// A small scene, and what the tests of the render command ask of its folder.
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "app/cache/particle_cache.hpp"
#include "app/commands/commands.hpp"
#include "app/scene/scene.hpp"
#include "output_support.hpp"
#include "render/output/atomic_file.hpp"
#include "render/output/output.hpp"

namespace fs = std::filesystem;
using namespace spindrift;
using output_test::TemporaryFolder;

inline const char* const small_scene = R"({
  "fluid": {"spacing": 0.08, "volumes": [{"box": {"min": [0, 0, 0], "max": [0.4, 0.64, 0.4]}}]},
  "domain": {"min": [0, 0, 0], "max": [0.96, 0.8, 0.4]},
  "video": {"width": 96, "height": 64, "duration": 0.2}
})";

inline app::Scene scene(const app::Overrides& set = {}) {
  return app::parse_scene(small_scene, "small.json", set);
}

inline app::RenderOptions options_for(const fs::path& folder) {
  app::RenderOptions options;
  options.output = folder;
  options.replace = true;
  options.quiet = true;
  return options;
}

/// The export formats of these names.
inline app::Exports exports(const std::vector<std::string>& names) {
  return app::exports_of(names);
}

inline std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline nlohmann::json report_of(const fs::path& folder) {
  return nlohmann::json::parse(bytes_of(folder / "run.json"));
}

inline int count(const fs::path& folder) {
  return static_cast<int>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}
