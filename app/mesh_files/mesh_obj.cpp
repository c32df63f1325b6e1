// Reads the vertices and faces of Wavefront OBJ files (Alias|Wavefront, "Object files (.obj)",
// 1995).
#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "app/errors/shown_text.hpp"
#include "app/mesh_files/mesh_readers.hpp"
#include "sim/geometry/mesh/polygon.hpp"

namespace spindrift::app {
namespace {

/// Calls f(keyword, rest) for each line. A backslash at the end of a line joins it with the next.
/// @throws MeshError when f does, with the line's number in front of the message
template <class F>
void for_each_line(std::string_view text, F f) {
  std::string joined;
  for (std::size_t number = 1; !text.empty();) {
    const std::size_t first = number++;
    std::string_view line = take_line(text);
    if (line.ends_with('\\')) {
      joined.clear();
      for (; line.ends_with('\\'); ++number) {
        joined.append(line.substr(0, line.size() - 1)).push_back(' ');
        line = take_line(text);
      }
      line = joined.append(line);
    }
    try {
      const std::string_view keyword = take_word(line);
      f(keyword, line);
    } catch (const MeshError& error) {
      throw MeshError(fmt::format("line {}: {}", first, error.what()));
    }
  }
}

glm::vec3 read_vertex(std::string_view rest) {
  glm::vec3 vertex;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string_view word = take_word(rest);
    const auto number = number_of<double>(word);
    if (!number) {
      throw MeshError(word.empty() ? std::string("a vertex (v) needs three numbers")
                                   : fmt::format("\"{}\" is not a number", shown(word)));
    }
    vertex[axis] = coordinate(*number);
  }
  return vertex;
}

/// The index, from 0, of the vertex that a word of a face such as "7/3/2" names. Only its first
/// number counts: it is counted from 1 or, when negative, backwards from −1, the last vertex before
/// the face.
/// @param before number of vertices before the face
/// @param all number of vertices in the file
std::uint32_t read_corner(std::string_view word, std::size_t before, std::size_t all) {
  const auto number = number_of<std::int64_t>(word.substr(0, word.find('/')));
  if (!number)
    throw MeshError(fmt::format("\"{}\" is not a vertex's number", shown(word)));
  const auto count = static_cast<std::int64_t>(*number < 0 ? before : all);
  if (*number == 0 || *number > count || *number < -count) {
    throw MeshError(fmt::format("there is no vertex {}; accepted: 1 ... {} and -{} ... -1", *number,
                                all, before));
  }
  return static_cast<std::uint32_t>(*number > 0 ? *number - 1 : count + *number);
}

}  // namespace

geometry::TriangleSurface read_obj(std::string_view text) {
  geometry::TriangleSurface surface;
  for_each_line(text, [&](std::string_view keyword, std::string_view rest) {
    if (keyword == "v")
      surface.vertices.push_back(read_vertex(rest));
  });
  if (surface.vertices.size() > std::numeric_limits<std::uint32_t>::max())
    throw MeshError("has more vertices than can be counted in 32 bits");
  std::size_t before = 0;
  std::vector<std::uint32_t> corners;
  for_each_line(text, [&](std::string_view keyword, std::string_view rest) {
    if (keyword == "v") {
      ++before;
    } else if (keyword == "f") {
      corners.clear();
      for (std::string_view word = take_word(rest); !word.empty() && word.front() != '#';
           word = take_word(rest))
        corners.push_back(read_corner(word, before, surface.vertices.size()));
      geometry::cut_polygon(surface.vertices, corners, surface.triangles);
    }
  });
  return surface;
}

}  // namespace spindrift::app
