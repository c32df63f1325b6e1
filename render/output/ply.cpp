// Writes PLY as described by Greg Turk, "The PLY Polygon File Format" (1994): a text header, then
// the elements in binary, little-endian, without padding.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include "render/output/atomic_file.hpp"
#include "render/output/output.hpp"

namespace spindrift::output {
namespace {

static_assert(std::endian::native == std::endian::little,
              "values are written as they lie in memory");

template <class T>
void put(AtomicFile& file, const T& value) {
  file.write(std::as_bytes(std::span(&value, 1)));
}

std::string float_properties(std::initializer_list<const char*> names) {
  std::string text;
  for (const char* name : names)
    text += std::string("property float ") + name + "\n";
  return text;
}

std::string header_begin() {
  return "ply\nformat binary_little_endian 1.0\ncomment written by spindrift\n";
}

// Returns whether an attribute is there; throws where it is then not as long as the positions.
bool present(std::size_t size, std::size_t expected, const char* name) {
  if (size != 0 && size != expected) {
    throw std::invalid_argument("write_ply: " + std::to_string(size) + " " + name + " for " +
                                std::to_string(expected) + " positions");
  }
  return size != 0;
}

std::string mesh_header(const Mesh& mesh, bool normals) {
  std::string text = header_begin() + "comment units: x y z in m\n";
  text += "element vertex " + std::to_string(mesh.vertices.size()) + "\n";
  text += float_properties({"x", "y", "z"});
  if (normals)
    text += float_properties({"nx", "ny", "nz"});
  text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  return text + "property list uchar int vertex_indices\nend_header\n";
}

}  // namespace

void write_ply(const std::filesystem::path& file, const Mesh& mesh) {
  const bool normals = present(mesh.normals.size(), mesh.vertices.size(), "normals");
  if (mesh.vertices.size() > std::numeric_limits<std::int32_t>::max())
    throw std::invalid_argument("write_ply: too many vertices for 32-bit indices");
  AtomicFile output(file);
  output.write(mesh_header(mesh, normals));
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    put(output, mesh.vertices[i]);
    if (normals)
      put(output, mesh.normals[i]);
  }
  for (const glm::uvec3& triangle : mesh.triangles) {
    put(output, std::uint8_t{3});
    put(output, triangle);
  }
  output.commit();
}

void write_ply(const std::filesystem::path& file, const ParticleAttributes& particles) {
  const std::size_t count = particles.positions.size();
  const bool velocities = present(particles.velocities.size(), count, "velocities");
  const bool densities = present(particles.densities.size(), count, "densities");
  const bool pressures = present(particles.pressures.size(), count, "pressures");
  const bool numbers = present(particles.numbers.size(), count, "numbers");

  std::string header = header_begin() + "comment units: x y z in m";
  header += velocities ? ", vx vy vz in m/s" : "";
  header += densities ? ", density in kg/m^3" : "";
  header += pressures ? ", pressure in Pa" : "";
  header += "\nelement vertex " + std::to_string(count) + "\n" + float_properties({"x", "y", "z"});
  header += velocities ? float_properties({"vx", "vy", "vz"}) : "";
  header += densities ? float_properties({"density"}) : "";
  header += pressures ? float_properties({"pressure"}) : "";
  header += numbers ? "property uint id\n" : "";
  header += "end_header\n";

  AtomicFile output(file);
  output.write(header);
  for (std::size_t i = 0; i < count; ++i) {
    put(output, particles.positions[i]);
    if (velocities)
      put(output, particles.velocities[i]);
    if (densities)
      put(output, particles.densities[i]);
    if (pressures)
      put(output, particles.pressures[i]);
    if (numbers)
      put(output, particles.numbers[i]);
  }
  output.commit();
}

}  // namespace spindrift::output
