// The liquid's surface as Wavefront OBJ, which nearly every program reads.
#pragma once

#include "app/exports/export_format.hpp"
#include "render/output/output.hpp"

namespace spindrift::app {

inline constexpr ExportFormat meshes_obj{
    .name = "meshes_obj",
    .folder = "meshes_obj",
    .extension = ".obj",
    .about = "the surface as OBJ",
    .of_surface = true,
    .bytes = [](double particles) { return 700 * surface_vertices(particles); },
    .write = [](const std::filesystem::path& file,
                const ExportedFrame& frame) { output::write_obj(file, frame.surface); }};

}  // namespace spindrift::app
