// Parsers that turn the bytes of OBJ and PLY files into triangles, and their helpers. Every number
// is checked before it is used.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::app {

using geometry::MeshError;

/// Reads the vertices (v) and faces (f) of a Wavefront OBJ file. Polygons are cut into triangles;
/// everything else, materials included, is skipped.
/// @throws MeshError with the line and what is wrong there
geometry::TriangleSurface read_obj(std::string_view text);

/// Reads the elements vertex and face of a PLY file, text or binary. Polygons are cut into
/// triangles; everything else is skipped.
/// @throws MeshError with the line or the byte and what is wrong there
geometry::TriangleSurface read_ply(std::string_view bytes);

/// The number that a whole word is; none where it is not a number or is out of the type's range.
template <class Number>
std::optional<Number> number_of(std::string_view word) {
  if (word.starts_with('+'))
    word.remove_prefix(1);
  Number number{};
  const char* end = word.data() + word.size();
  const auto [at, error] = std::from_chars(word.data(), end, number);
  return error == std::errc() && at == end ? std::optional(number) : std::nullopt;
}

/// Removes the first word of a text, with the white space before it, and returns the word.
std::string_view take_word(std::string_view& text);

/// Removes the first line of a text, and returns it without its line end.
std::string_view take_line(std::string_view& text);

/// Converts a coordinate to a float.
/// @throws MeshError where it is not finite or beyond a float's range
float coordinate(double number);

}  // namespace spindrift::app
