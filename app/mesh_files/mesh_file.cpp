#include "app/mesh_files/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/errors/nearest_name.hpp"
#include "app/mesh_files/mesh_readers.hpp"
#include "render/output/input_file.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

/// The file name's extension with its point, in lower case.
std::string ending(const fs::path& file) {
  std::string text = file.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

bool is_mesh_file(const fs::path& file) {
  return ending(file) == ".obj" || ending(file) == ".ply";
}

/// "; did you mean ...?" with the mesh file of the folder whose name is most similar, or empty
/// where none is similar.
std::string similar_file(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::vector<std::string> there;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (is_mesh_file(entry.path()))
      there.push_back(entry.path().filename().string());
  std::sort(there.begin(), there.end());
  const std::vector<std::string_view> names(there.begin(), there.end());
  const std::string_view nearest = nearest_name(file.filename().string(), names);
  return nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
}

/// The content of a file.
/// @throws MeshError which, like all MeshErrors, does not name the file
std::string bytes_of(const fs::path& file) {
  try {
    return output::read_file(file);
  } catch (const std::runtime_error& error) {
    const std::string_view what = error.what();
    const std::string name = file.string() + ": ";
    throw MeshError(std::string(what.substr(what.starts_with(name) ? name.size() : 0)));
  }
}

}  // namespace

geometry::TriangleSurface read_mesh_file(const fs::path& file) {
  if (!is_mesh_file(file))
    throw MeshError("is not named .obj or .ply, the files that are read");
  std::error_code none;
  if (!fs::exists(file, none))
    throw MeshError(fmt::format("there is no such file{}", similar_file(file)));
  const std::string bytes = bytes_of(file);
  return ending(file) == ".obj" ? read_obj(bytes) : read_ply(bytes);
}

std::string_view take_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  if (line.ends_with('\r'))
    line.remove_suffix(1);
  return line;
}

std::string_view take_word(std::string_view& text) {
  constexpr std::string_view spaces = " \t\r\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(spaces), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(spaces));
  text.remove_prefix(word.size());
  return word;
}

float coordinate(double number) {
  const auto narrow = static_cast<float>(number);
  if (!std::isfinite(narrow)) {
    throw MeshError(fmt::format("{} is not a coordinate; accepted: {:.2g} ... {:.2g}", number,
                                std::numeric_limits<float>::lowest(),
                                std::numeric_limits<float>::max()));
  }
  return narrow;
}

}  // namespace spindrift::app
