// A body bounded by triangles that a file holds.
#pragma once

#include <memory>

#include "sim/geometry/mesh/mesh_body.hpp"
#include "sim/geometry/mesh/smooth_normals.hpp"
#include "sim/geometry/shapes/box.hpp"

namespace spindrift::geometry {

/// A mesh as loops over particles look at it, wherever they run.
struct MeshSolid {
  const MeshView* view = nullptr;  ///< where loops find it

  SPINDRIFT_HD glm::vec3 push_out(const glm::vec3& p) const { return view->push_out(p); }
};

struct TriangleMesh {
  std::string file;                      ///< OBJ or PLY
  float scale = 1.f;                     ///< metres per unit of the file
  glm::vec3 rotate{0.f};                 ///< about x, then y, then z, after scaling, degrees
  glm::vec3 translate{0.f};              ///< after rotating, m
  std::shared_ptr<const MeshBody> body;  ///< what was read, in its place; all that is looked at

  static constexpr std::string_view name = "mesh";
  static constexpr auto fields = std::tuple{
      Field{"file", &TriangleMesh::file,
            "OBJ or PLY file with a closed surface of triangles; its path from the scene file's "
            "folder",
            Range{}, "", Presence::required},
      Field{"scale", &TriangleMesh::scale, "size of the file's unit", lengths, "m"},
      Field{"rotate", &TriangleMesh::rotate,
            "angles about the x, then the y, then the z axis, after scaling", Range{-360., 360.},
            "degrees"},
      Field{"translate", &TriangleMesh::translate, "where the file's origin is put", places, "m"}};

  std::string problem() const { return ""; }  // said where it is read

  Box bounds() const { return body->bounds(); }
  /// Of a mesh whose parts overlap, the sum of theirs.
  double volume() const { return enclosed_volume(body->surface()); }
  double area() const { return area_of(body->surface()); }
  glm::bvec3 flat_along() const { return glm::bvec3(true); }
  std::vector<SurfaceSample> samples(float spacing) const { return body->sample(spacing); }
  void tessellate(Tessellation& into) const { tessellate_smooth(into, body->surface()); }
  std::optional<TriangleMesh> mirrored(const Mirror&) const { return std::nullopt; }
};

}  // namespace spindrift::geometry
