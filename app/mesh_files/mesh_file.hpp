// Reads the OBJ and PLY files that scenes use as shapes.
#pragma once

#include <filesystem>

#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::app {

/// Reads the triangles of an OBJ or PLY file, in the file's own unit of length. Polygons are cut
/// into triangles; nothing else is changed or repaired.
/// @throws MeshError when the file is missing, of another kind, or can't be read; the message gives
/// the line or byte, but does not name the file
geometry::TriangleSurface read_mesh_file(const std::filesystem::path& file);

}  // namespace spindrift::app
