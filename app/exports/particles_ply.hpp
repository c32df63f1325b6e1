// The particles with all their values as PLY.
#pragma once

#include "app/exports/export_format.hpp"

namespace spindrift::app {

/// Writes a frame's particles in the order of their ids, so that a particle has the same place in
/// every file; with the ids where particles come and go.
void write_particles_ply(const std::filesystem::path& file, const ExportedFrame& exported);

inline constexpr ExportFormat particles_ply{
    .name = "particles",
    .folder = "particles_ply",
    .extension = ".ply",
    .about = "the particles as PLY",
    .of_surface = false,
    .bytes = [](double particles) { return 36 * particles; },
    .write = write_particles_ply};

}  // namespace spindrift::app
