// What a run can leave of each frame besides its picture. A format is one file of this folder, and
// one line in export_formats.cpp.
#pragma once

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

#include "app/scene/scene.hpp"
#include "render/mesh.hpp"
#include "sim/core/frame.hpp"

namespace spindrift::app {

/// A frame that is exported.
struct ExportedFrame {
  const Scene& scene;
  const sim::Frame& particles;  ///< without the liquid that is still in nozzles
  const Mesh& surface;          ///< of the liquid; empty where no format that is asked for needs it
};

/// A kind of file of which a run leaves one for each frame.
struct ExportFormat {
  std::string_view name;       ///< on the command line
  std::string_view folder;     ///< of the files in the run's folder, and their name in run.json
  std::string_view extension;  ///< of the files, with the dot
  std::string_view about;      ///< what it is, for the help
  bool of_surface;             ///< whether it is of the liquid's surface, not of its particles
  /// About how large the file of a frame is, bytes.
  double (*bytes)(double particles);
  /// @throws std::runtime_error naming the file and the reason
  void (*write)(const std::filesystem::path& file, const ExportedFrame& frame);
};

/// All formats.
std::span<const ExportFormat> export_formats();

/// The formats that a run leaves; none appears twice.
using Exports = std::vector<const ExportFormat*>;

/// The formats of some names. @throws std::out_of_range for a name that no format has
Exports exports_of(std::span<const std::string> names);

/// Whether any of the formats is of the liquid's surface.
bool any_of_surface(const Exports& exports);

/// About how many triangles' vertices, as many as particles in the outermost layer, a liquid has.
double surface_vertices(double particles);

}  // namespace spindrift::app
