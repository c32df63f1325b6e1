// Mesh files, OBJ and PLY, from their bytes to the closed surface of a solid.
#include "app/mesh_files/mesh_readers.hpp"
#include "sim/geometry/mesh/closed_surface.hpp"
#include "tests/fuzz/support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spindrift;
  const std::string_view bytes = fuzz::text_of(data, size);
  try {
    const geometry::TriangleSurface closed = geometry::closed_surface(
        bytes.starts_with("ply") ? app::read_ply(bytes) : app::read_obj(bytes));
    fuzz::require(geometry::enclosed_volume(closed) > 0);
    const geometry::TriangleSurface again = geometry::closed_surface(closed);
    fuzz::require(again.triangles.size() == closed.triangles.size());
    fuzz::require(geometry::inner_shells(again) == geometry::inner_shells(closed));
  } catch (const geometry::MeshError&) {
  }
  return 0;
}
