#include "sim/solid.hpp"

#include "sim/shapes/mesh_body.hpp"

namespace spindrift::sim {
namespace {

Solid solid(const Box& b) {
  return {.kind = Solid::Kind::box, .a = b.min, .b = b.max};
}
Solid solid(const Sphere& s) {
  return {.kind = Solid::Kind::sphere, .a = s.center, .radius = s.radius};
}
Solid solid(const Cylinder& c) {
  return {.kind = Solid::Kind::cylinder, .a = c.from, .b = c.to, .radius = c.radius};
}
Solid solid(const Capsule& c) {
  return {.kind = Solid::Kind::capsule, .a = c.from, .b = c.to, .radius = c.radius};
}
Solid solid(const TriangleMesh& m) {
  return {.kind = Solid::Kind::mesh, .mesh = &m.body->view()};
}

}  // namespace

Solid solid_of(const Shape& shape) {
  return std::visit([](const auto& s) { return solid(s); }, shape);
}

std::vector<Solid> solids_of(const std::vector<Obstacle>& obstacles) {
  std::vector<Solid> solids;
  for (const Obstacle& obstacle : obstacles)
    solids.push_back(solid_of(obstacle.shape));
  return solids;
}

Vec3<float> push_out(const Shape& shape, Vec3<float> p) {
  return push_out(solid_of(shape), p);
}

bool contains(const Shape& shape, Vec3<float> p) {
  return contains(solid_of(shape), p);
}

}  // namespace spindrift::sim
