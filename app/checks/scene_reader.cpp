#include "app/checks/scene_reader.hpp"

#include <fmt/format.h>

#include <istream>

#include "app/checks/scene_checks.hpp"
#include "app/checks/scene_meshes.hpp"
#include "app/scene/scene.hpp"
#include "app/scene/scene_fields.hpp"
#include "app/tables/table_reader.hpp"
#include "app/tables/values.hpp"
#include "render/output/input_file.hpp"

namespace spindrift::app {
namespace {

constexpr std::size_t most_scene_bytes = 32 << 20;

std::string too_long(const std::string& source) {
  return fmt::format("{}: longer than {} MB; no scene is", source, most_scene_bytes >> 20);
}

}  // namespace

Scene parse_scene(std::string_view text, const std::filesystem::path& source,
                  const Overrides& overrides) {
  SceneDocument document(text, source.string());
  const Json defaults = to_json(Scene{});
  for (const std::string& assignment : overrides)
    document.override_value(assignment, defaults);
  Scene scene;
  scene.name = source.stem().string();
  read_document(document, scene);
  auto& fluid = scene.simulation.fluid;
  if (!fluid.emitters.empty() && !document.root().at("fluid").contains("volumes"))
    fluid.volumes.clear();  // emitters replace the default volume
  load_meshes(scene, document, source.parent_path());
  check_scene(scene, document);
  return scene;
}

std::string scene_text(const std::filesystem::path& file) {
  try {
    std::error_code unknown;
    if (std::filesystem::file_size(file, unknown) > most_scene_bytes && !unknown)
      throw std::runtime_error(too_long(file.string()));
    return output::read_file(file);
  } catch (const std::exception& error) {
    throw SceneError(error.what());
  }
}

std::string scene_text(std::istream& stream, const std::string& source) {
  std::string text(most_scene_bytes + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > most_scene_bytes)
    throw SceneError(too_long(source));
  return text;
}

Scene read_scene(const std::filesystem::path& file, const Overrides& overrides) {
  return parse_scene(scene_text(file), file, overrides);
}

}  // namespace spindrift::app
