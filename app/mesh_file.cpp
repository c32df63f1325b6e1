#include "app/mesh_file.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <cctype>
#include <cmath>
#include <string>
#include <vector>

#include "app/closed_surface.hpp"
#include "app/nearest_name.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

bool is_mesh_file(const fs::path& file) {
  std::string ending = file.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending == ".obj" || ending == ".ply";
}

/// "; did you mean ...?" with the most similar mesh file of the folder, if there is one.
std::string similar_file(const fs::path& file) {
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  std::vector<std::string> there;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (is_mesh_file(entry.path())) {
      there.push_back(entry.path().filename().string());
    }
  }
  std::sort(there.begin(), there.end());
  const std::vector<std::string_view> names(there.begin(), there.end());
  const std::string_view nearest = nearest_name(file.filename().string(), names);
  return nearest.empty() ? "" : fmt::format("; did you mean \"{}\"?", nearest);
}

void append(const aiMesh& part, sim::TriangleSurface& surface) {
  const auto first = static_cast<std::uint32_t>(surface.vertices.size());
  for (unsigned i = 0; i < part.mNumVertices; ++i) {
    const aiVector3D& v = part.mVertices[i];
    surface.vertices.push_back({v.x, v.y, v.z});
  }
  for (unsigned i = 0; i < part.mNumFaces; ++i) {
    const aiFace& face = part.mFaces[i];
    if (face.mNumIndices == 3) {  // neither a point nor a line
      surface.triangles.push_back(first +
                                  glm::uvec3(face.mIndices[0], face.mIndices[1], face.mIndices[2]));
    }
  }
}

}  // namespace

sim::TriangleSurface read_mesh_file(const fs::path& file) {
  if (!is_mesh_file(file)) {
    throw MeshError("is not named .obj or .ply, the files that are read");
  }
  std::error_code none;
  if (!fs::exists(file, none)) {
    throw MeshError(fmt::format("there is no such file{}", similar_file(file)));
  }
  if (!fs::is_regular_file(file, none)) {
    throw MeshError("is not a file");
  }
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (!scene) {
    throw MeshError(fmt::format("can't be read: {}", importer.GetErrorString()));
  }
  sim::TriangleSurface surface;
  for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
    append(*scene->mMeshes[i], surface);
  }
  for (const glm::vec3& v : surface.vertices) {
    if (!std::isfinite(v.x + v.y + v.z)) {
      throw MeshError("has a vertex that is not a number");
    }
  }
  return surface;
}

}  // namespace spindrift::app
