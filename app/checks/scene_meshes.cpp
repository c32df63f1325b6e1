#include "app/checks/scene_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "app/mesh_files/mesh_file.hpp"
#include "sim/geometry/mesh/closed_surface.hpp"
#include "sim/geometry/mesh/mesh_body.hpp"

namespace spindrift::app {
namespace {

// A mesh wider than these is more likely in another unit than meant to be so large.
constexpr float most_domains = 10.f;     // widths of the domain
constexpr float most_spacings = 2000.f;  // particle spacings

float widest(const sim::Box& box) {
  const glm::vec3 size = box.max - box.min;
  return std::max({size.x, size.y, size.z});
}

/// Scales the surface, rotates it about x, y and z in this order, and moves it, as the mesh says.
void place(sim::TriangleSurface& surface, const sim::TriangleMesh& mesh) {
  const glm::dmat3 turn = geometry::rotation_by(glm::dvec3(mesh.rotate));
  for (glm::vec3& v : surface.vertices) {
    const glm::dvec3 scaled = double{mesh.scale} * glm::dvec3(v);
    v = glm::vec3(turn * scaled + glm::dvec3(mesh.translate));
  }
}

class MeshLoader {
 public:
  MeshLoader(const Scene& scene, const SceneDocument& document, std::filesystem::path folder)
      : spacing_(scene.simulation.fluid.spacing),
        domain_{scene.simulation.domain.min, scene.simulation.domain.max},
        document_(document),
        folder_(std::move(folder)) {}

  /// The problems of the meshes loaded so far.
  const std::vector<Problem>& problems() const { return problems_; }

  /// Loads the mesh of a shape that is one.
  /// @param owner key path of the volume, obstacle or sink that has the shape
  void load(sim::Shape& shape, const std::string& owner) {
    auto* mesh = std::get_if<sim::TriangleMesh>(&shape);
    if (!mesh)
      return;
    const std::string path = child_path(owner, "mesh");
    const std::filesystem::path file = folder_ / mesh->file;
    sim::TriangleSurface surface;
    try {
      surface = geometry::closed_surface(read_mesh_file(file));
    } catch (const geometry::MeshError& error) {
      return complain(child_path(path, "file"), fmt::format("{}: {}", file.string(), error.what()));
    }
    place(surface, *mesh);
    if (const std::string wrong = wrong_size(surface); !wrong.empty())
      return complain(path, wrong);
    mesh->body = std::make_shared<const sim::MeshBody>(std::move(surface), spacing_);
  }

 private:
  void complain(const std::string& path, const std::string& message) {
    problems_.push_back(document_.problem(path, message));
  }

  /// A message about a surface that is too small or too large; empty where its size is right.
  std::string wrong_size(const sim::TriangleSurface& surface) const {
    const float width = widest(sim::bounds_of(surface));
    const float most = std::min(most_domains * widest(domain_), most_spacings * spacing_);
    if (!(most > 0.f) || (width >= spacing_ && width <= most))
      return "";
    return fmt::format(
        "{:g} m wide; accepted: {:g} ... {:g} m, from one particle spacing to {:g} domain widths "
        "or {:g} spacings (scale sets the file's unit)",
        width, spacing_, most, most_domains, most_spacings);
  }

  float spacing_;
  sim::Box domain_;
  const SceneDocument& document_;
  std::filesystem::path folder_;
  std::vector<Problem> problems_;
};

/// Calls f(shape, path) for the shapes of all volumes, obstacles and sinks of a scene.
template <class Scene, class F>
void for_each_shape(Scene& scene, F f) {
  auto& simulation = scene.simulation;
  for (std::size_t i = 0; i < simulation.fluid.volumes.size(); ++i)
    f(simulation.fluid.volumes[i].shape, child_path("fluid.volumes", i));
  for (std::size_t i = 0; i < simulation.obstacles.size(); ++i)
    f(simulation.obstacles[i].shape, child_path("obstacles", i));
  for (std::size_t i = 0; i < simulation.sinks.size(); ++i)
    f(simulation.sinks[i].shape, child_path("sinks", i));
}

}  // namespace

void load_meshes(Scene& scene, const SceneDocument& document, const std::filesystem::path& folder) {
  MeshLoader loader(scene, document, folder);
  for_each_shape(scene,
                 [&](sim::Shape& shape, const std::string& path) { loader.load(shape, path); });
  throw_if_any(loader.problems());
}

std::vector<Diagnostic> mesh_warnings(const Scene& scene) {
  std::vector<Diagnostic> warnings;
  for_each_shape(scene, [&](const sim::Shape& shape, const std::string& path) {
    const auto* mesh = std::get_if<sim::TriangleMesh>(&shape);
    const std::size_t shells = mesh ? geometry::inner_shells(mesh->body->surface()) : 0;
    if (shells > 0)
      warnings.push_back(
          {child_path(path, "mesh"),
           fmt::format(
               "{} has {} inner shell{}: what is within {} is hollow, whichever way triangles face",
               mesh->file, shells, shells == 1 ? "" : "s", shells == 1 ? "it" : "them")});
  });
  return warnings;
}

}  // namespace spindrift::app
