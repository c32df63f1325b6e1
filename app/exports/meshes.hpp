// The liquid's surface as PLY.
#pragma once

#include "app/exports/export_format.hpp"
#include "render/output/output.hpp"

namespace spindrift::app {

inline constexpr ExportFormat meshes{
    .name = "meshes",
    .folder = "meshes",
    .extension = ".ply",
    .about = "the surface as PLY",
    .of_surface = true,
    // Two triangles of 13 bytes for each vertex of 24, four vertices to a particle.
    .bytes = [](double particles) { return 250 * surface_vertices(particles); },
    .write = [](const std::filesystem::path& file,
                const ExportedFrame& frame) { output::write_ply(file, frame.surface); }};

}  // namespace spindrift::app
