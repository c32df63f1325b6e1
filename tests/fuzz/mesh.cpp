// Mesh files, OBJ and PLY, from their bytes to the closed surface of a solid.
#include "app/closed_surface.hpp"
#include "app/mesh_readers.hpp"
#include "tests/fuzz/support.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace spindrift;
  const std::string_view bytes = fuzz::text_of(data, size);
  try {
    const sim::TriangleSurface closed =
        app::closed_surface(bytes.starts_with("ply") ? app::read_ply(bytes) : app::read_obj(bytes));
    fuzz::require(app::enclosed_volume(closed) > 0);
    const sim::TriangleSurface again = app::closed_surface(closed);
    fuzz::require(again.triangles.size() == closed.triangles.size());
    fuzz::require(app::inner_shells(again) == app::inner_shells(closed));
  } catch (const app::MeshError&) {
  }
  return 0;
}
