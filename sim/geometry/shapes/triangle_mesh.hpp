// A solid bounded by the triangles of a mesh file, as a shape.
#pragma once

#include <memory>

#include "sim/geometry/mesh/mesh_body.hpp"
#include "sim/geometry/mesh/smooth_normals.hpp"
#include "sim/geometry/shapes/box.hpp"

namespace spindrift::geometry {

/// The representation of a mesh in loops over particles, on the host or on a device.
struct MeshSolid {
  const MeshView* view = nullptr;  ///< in memory that the loops can read

  /// Calls MeshView::push_out().
  SPINDRIFT_HD glm::vec3 push_out(const glm::vec3& p) const { return view->push_out(p); }
};

/// A solid read from a mesh file. Its members are described in `Box` and need `body`; `MeshSolid`
/// stands for it in collisions.
struct TriangleMesh {
  std::string file;                      ///< path of the OBJ or PLY file
  float scale = 1.f;                     ///< metres per unit of the file
  glm::vec3 rotate{0.f};                 ///< angles about x, then y, then z, after scaling, degrees
  glm::vec3 translate{0.f};              ///< after rotating, m
  std::shared_ptr<const MeshBody> body;  ///< the mesh that was read, scaled, rotated and translated

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

  std::string problem() const { return ""; }  // the mesh reader reports problems

  Box bounds() const { return body->bounds(); }
  /// The volume, m³; where parts of the mesh overlap, the sum of the parts' volumes.
  double volume() const { return enclosed_volume(body->surface()); }
  double area() const { return area_of(body->surface()); }
  glm::bvec3 flat_along() const { return glm::bvec3(true); }
  std::vector<SurfaceSample> samples(float spacing) const { return body->sample(spacing); }
  void tessellate(Tessellation& into) const { tessellate_smooth(into, body->surface()); }
  std::optional<TriangleMesh> mirrored(const Mirror&) const { return std::nullopt; }
};

}  // namespace spindrift::geometry
