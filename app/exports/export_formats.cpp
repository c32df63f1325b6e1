#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>

#include "app/exports/export_format.hpp"
#include "app/exports/meshes.hpp"
#include "app/exports/meshes_obj.hpp"
#include "app/exports/particles_ply.hpp"

namespace spindrift::app {

std::span<const ExportFormat> export_formats() {
  static constexpr std::array formats{meshes, meshes_obj, particles_ply};
  return formats;
}

Exports exports_of(std::span<const std::string> names) {
  Exports exports;
  for (const std::string& name : names) {
    const auto all = export_formats();
    const auto format = std::find_if(all.begin(), all.end(),
                                     [&](const ExportFormat& one) { return one.name == name; });
    if (format == all.end())
      throw std::out_of_range("there is no export format \"" + name + "\"");
    if (std::find(exports.begin(), exports.end(), &*format) == exports.end())
      exports.push_back(&*format);
  }
  return exports;
}

bool any_of_surface(const Exports& exports) {
  return std::any_of(exports.begin(), exports.end(),
                     [](const ExportFormat* format) { return format->of_surface; });
}

double surface_vertices(double particles) {
  return 6 * std::pow(particles, 2. / 3);
}

}  // namespace spindrift::app
