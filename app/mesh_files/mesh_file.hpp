// Triangles from OBJ and PLY files.
#pragma once

#include <filesystem>

#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::app {

/// The triangles of a file as they are there, polygons cut up; in the file's own unit.
/// @throws MeshError when the file is missing, of another kind, or can't be read; it says where in
/// the file, and does not name the file
geometry::TriangleSurface read_mesh_file(const std::filesystem::path& file);

}  // namespace spindrift::app
