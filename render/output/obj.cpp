// Writes OBJ as described in "Object Files (.obj)", Wavefront Advanced Visualizer manual, appendix
// B1: a line of text for each vertex (v), normal (vn) and face (f); indices count from 1.

#include <fmt/format.h>

#include <iterator>
#include <utility>

#include "render/output/atomic_file.hpp"
#include "render/output/mesh_normals.hpp"
#include "render/output/output.hpp"

namespace spindrift::output {
namespace {

template <class... Values>
void write(AtomicFile& file, fmt::format_string<Values...> format, Values&&... values) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
  file.write(std::string_view(text.data(), text.size()));
}

}  // namespace

void write_obj(const std::filesystem::path& file, const Mesh& mesh) {
  const bool normals = has_normals(mesh);
  AtomicFile output(file);
  write(output, "# written by spindrift; x y z in m\n");
  for (const glm::vec3& p : mesh.vertices)
    write(output, "v {} {} {}\n", p.x, p.y, p.z);
  if (normals)
    for (const glm::vec3& n : mesh.normals)
      write(output, "vn {} {} {}\n", n.x, n.y, n.z);
  for (const glm::uvec3& triangle : mesh.triangles) {
    const glm::uvec3 t = triangle + 1u;
    if (normals)
      write(output, "f {0}//{0} {1}//{1} {2}//{2}\n", t.x, t.y, t.z);
    else
      write(output, "f {} {} {}\n", t.x, t.y, t.z);
  }
  output.commit();
}

}  // namespace spindrift::output
