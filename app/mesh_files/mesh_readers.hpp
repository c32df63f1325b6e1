// Mesh files as bytes, made into triangles. Every number is checked before it is used.
#pragma once

#include <charconv>
#include <optional>
#include <string_view>

#include "sim/geometry/mesh/triangle_surface.hpp"

namespace spindrift::app {

using geometry::MeshError;

/// The vertices (v) and faces (f) of a Wavefront OBJ; polygons are cut up, all else is left out,
/// materials too. @throws MeshError with the line and what is wrong there
geometry::TriangleSurface read_obj(std::string_view text);

/// The elements vertex and face of a PLY, as text or binary; polygons are cut up, all else is left
/// out. @throws MeshError with the line or the byte and what is wrong there
geometry::TriangleSurface read_ply(std::string_view bytes);

/// A whole word as a number; none where it is not one, or is out of the type's range.
template <class Number>
std::optional<Number> number_of(std::string_view word) {
  if (word.starts_with('+'))
    word.remove_prefix(1);
  Number number{};
  const char* end = word.data() + word.size();
  const auto [at, error] = std::from_chars(word.data(), end, number);
  return error == std::errc() && at == end ? std::optional(number) : std::nullopt;
}

/// The start of a text without its spaces, tabs and carriage returns in front; takes it off.
std::string_view take_word(std::string_view& text);

/// The next line without its end; takes it off.
std::string_view take_line(std::string_view& text);

/// A coordinate as meshes have it. @throws MeshError where it is not finite or beyond a float's
/// range
float coordinate(double number);

}  // namespace spindrift::app
