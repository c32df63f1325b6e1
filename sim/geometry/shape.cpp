#include "sim/geometry/shape.hpp"

#include "sim/geometry/solid.hpp"

namespace spindrift::geometry {
namespace {

template <class S>
const S& seen_by_loops(const S& shape) {
  return shape;
}
MeshSolid seen_by_loops(const TriangleMesh& mesh) {
  return {&mesh.body->view()};
}

}  // namespace

std::string problem_of(const Shape& shape) {
  return std::visit([](const auto& s) { return s.problem(); }, shape);
}

std::string_view name_of(const Shape& shape) {
  return std::visit([](const auto& s) { return s.name; }, shape);
}

Box bounds_of(const Shape& shape) {
  return std::visit([](const auto& s) { return s.bounds(); }, shape);
}

double volume_of(const Shape& shape) {
  return std::visit([](const auto& s) { return s.volume(); }, shape);
}

double area_of(const Shape& shape) {
  return std::visit([](const auto& s) { return s.area(); }, shape);
}

glm::bvec3 flat_along(const Shape& shape) {
  return std::visit([](const auto& s) { return s.flat_along(); }, shape);
}

std::vector<SurfaceSample> sample_surface(const Shape& shape, float spacing) {
  return std::visit([&](const auto& s) { return s.samples(spacing); }, shape);
}

void tessellate(Tessellation& into, const Shape& shape) {
  std::visit([&](const auto& s) { s.tessellate(into); }, shape);
}

std::optional<Shape> mirrored(const Shape& shape, const Mirror& mirror) {
  return std::visit(
      [&](const auto& s) -> std::optional<Shape> {
        if (const auto image = s.mirrored(mirror))
          return *image;
        return std::nullopt;
      },
      shape);
}

bool is_inside(const Shape& shape, const glm::vec3& p) {
  return std::visit([&](const auto& s) { return is_in(seen_by_loops(s), p); }, shape);
}

glm::vec3 push_out(const Shape& shape, const glm::vec3& p) {
  return std::visit([&](const auto& s) { return seen_by_loops(s).push_out(p); }, shape);
}

}  // namespace spindrift::geometry
