// Writes PLY as described by Greg Turk, "The PLY Polygon File Format" (1994): a text header, then
// the elements in binary, little-endian, without padding.

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>

#include "render/output/atomic_file.hpp"
#include "render/output/mesh_normals.hpp"
#include "render/output/output.hpp"

namespace spindrift::output {
namespace {

static_assert(std::endian::native == std::endian::little,
              "values are written as they lie in memory");

template <class T>
void put(AtomicFile& file, const T& value) {
  file.write(std::as_bytes(std::span(&value, 1)));
}

/// The lines of a header for properties of one type, whose names have spaces between them.
std::string property_lines(const char* type, std::string_view names) {
  std::string text;
  for (std::size_t begin = 0; begin < names.size();) {
    const std::size_t end = std::min(names.find(' ', begin), names.size());
    text += fmt::format("property {} {}\n", type, names.substr(begin, end - begin));
    begin = end + 1;
  }
  return text;
}

std::string header_begin() {
  return "ply\nformat binary_little_endian 1.0\ncomment written by spindrift\n";
}

std::string mesh_header(const Mesh& mesh, bool normals) {
  std::string text = header_begin() + "comment units: x y z in m\n";
  text += "element vertex " + std::to_string(mesh.vertices.size()) + "\n";
  text += property_lines("float", "x y z");
  if (normals)
    text += property_lines("float", "nx ny nz");
  text += "element face " + std::to_string(mesh.triangles.size()) + "\n";
  return text + "property list uchar int vertex_indices\nend_header\n";
}

std::size_t size_of(const ParticleAttribute& attribute) {
  return std::visit([](const auto& values) { return values.size(); }, attribute.values);
}

}  // namespace

void write_ply(const std::filesystem::path& file, const Mesh& mesh) {
  const bool normals = has_normals(mesh);
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

void write_ply(const std::filesystem::path& file, std::span<const ParticleAttribute> attributes) {
  const std::size_t count = attributes.empty() ? 0 : size_of(attributes.front());
  std::string units, properties;
  for (const ParticleAttribute& attribute : attributes) {
    if (size_of(attribute) != count)
      throw std::invalid_argument(fmt::format("write_ply: {} values of {} for {} of {}",
                                              size_of(attribute), attribute.properties, count,
                                              attributes.front().properties));
    if (!attribute.unit.empty())
      units += fmt::format("{}{} in {}", units.empty() ? "" : ", ", attribute.properties,
                           attribute.unit);
    const bool whole = std::holds_alternative<std::vector<std::uint32_t>>(attribute.values);
    properties += property_lines(whole ? "uint" : "float", attribute.properties);
  }
  AtomicFile output(file);
  output.write(header_begin() + "comment units: " + units + "\n" +
               fmt::format("element vertex {}\n", count) + properties + "end_header\n");
  for (std::size_t i = 0; i < count; ++i)
    for (const ParticleAttribute& attribute : attributes)
      std::visit([&](const auto& values) { put(output, values[i]); }, attribute.values);
  output.commit();
}

}  // namespace spindrift::output
