// Views and obstacle meshes.
#include <catch2/catch.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>
#include <tuple>
#include <vector>

#include "app/checks/estimate.hpp"
#include "app/draw/obstacle_mesh.hpp"
#include "app/scene/camera.hpp"
#include "sim/geometry/shape.hpp"

namespace app_camera_tests {

using namespace spindrift;
using namespace spindrift::app;

namespace {

/// Where a point is in the picture: x and y in [-1, 1], z > 0 in front of the camera.
glm::vec3 in_picture(const gl::View& view, float aspect, const glm::vec3& point) {
  const glm::mat4 eye = glm::lookAt(view.position, view.target, view.up);
  const glm::mat4 lens = glm::perspective(glm::radians(view.vertical_fov), aspect, 0.01f, 1e5f);
  const glm::vec4 clip = lens * eye * glm::vec4(point, 1.f);
  return {clip.x / clip.w, clip.y / clip.w, clip.w};
}

double volume_inside(const Mesh& mesh) {
  double six_volumes = 0.;
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::dvec3 a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
    six_volumes += glm::dot(a, glm::cross(b, c));
  }
  return six_volumes / 6.;
}

Mesh mesh_of(const sim::Shape& shape) {
  const std::vector<sim::Obstacle> obstacles{{shape}};
  return tessellate(obstacles);
}

/// Triangles face the way their normals point, and every edge, by its ends' places, is passed once
/// in each direction.
void check_closed(const Mesh& mesh) {
  using Place = std::tuple<long, long, long>;
  const auto place = [&](unsigned i) {
    const glm::vec3 v = mesh.vertices[i] * 1e4f;
    return Place{std::lround(v.x), std::lround(v.y), std::lround(v.z)};
  };
  std::map<std::pair<Place, Place>, int> edges;
  int backward = 0;
  REQUIRE(mesh.normals.size() == mesh.vertices.size());
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 face = glm::cross(mesh.vertices[t.y] - mesh.vertices[t.x],
                                      mesh.vertices[t.z] - mesh.vertices[t.x]);
    for (int i = 0; i < 3; ++i) {
      backward += glm::dot(face, mesh.normals[t[i]]) <= 0.f;
      ++edges[{place(t[i]), place(t[(i + 1) % 3])}];
      --edges[{place(t[(i + 1) % 3]), place(t[i])}];
    }
  }
  CHECK(backward == 0);
  for (const auto& [edge, balance] : edges)
    REQUIRE(balance == 0);
}

}  // namespace

TEST_CASE("the automatic camera keeps the whole domain in the picture, and fills it") {
  const std::vector<sim::DomainSettings> boxes{{{0.f, 0.f, 0.f}, {3.2f, 2.f, 0.8f}},
                                               {{-2.55f, -0.05f, -0.05f}, {2.55f, 5.05f, 5.05f}},
                                               {{10.f, -7.f, 3.f}, {10.1f, 20.f, 3.1f}},
                                               {{0.f, 0.f, 0.f}, {0.001f, 0.002f, 0.001f}},
                                               {{-500.f, 0.f, -5.f}, {500.f, 30.f, 5.f}},
                                               {{0.f, 0.f, 0.f}, {1.f, 1.f, 30.f}},
                                               {{100.f, 100.f, 100.f}, {101.f, 101.f, 101.f}}};
  for (const auto& box : boxes) {
    for (const float aspect : {16.f / 9.f, 1.f, 0.5f, 3.f}) {
      const gl::View view = view_at({}, box, aspect, 1.);
      float most = 0.f;
      for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p{(corner & 1) ? box.max.x : box.min.x,
                          (corner & 2) ? box.max.y : box.min.y,
                          (corner & 4) ? box.max.z : box.min.z};
        const glm::vec3 seen = in_picture(view, aspect, p);
        INFO(corner << " at " << seen.x << " " << seen.y);
        CHECK(seen.z > 0.f);
        CHECK(std::abs(seen.x) < 0.97f);
        CHECK(std::abs(seen.y) < 0.97f);
        most = std::max({most, std::abs(seen.x), std::abs(seen.y)});
      }
      CHECK(most > 0.85f);
      CHECK(view.position.y > view.target.y);
    }
  }
}

TEST_CASE("the camera passes through its keys, rests at the ends and never overshoots") {
  CameraSettings camera;
  camera.keyframes = {{1.f, {0, 1, 4}, {0, 0, 0}, {0, 1, 0}, 30.f},
                      {2.f, {2, 1, 4}, {0, 0, 0}, {0, 1, 0}, 40.f},
                      {4.f, {2, 3, 4}, {1, 0, 0}, {0, 1, 0}, 50.f}};
  const sim::DomainSettings box;
  for (const CameraKey& key : camera.keyframes) {
    const gl::View view = view_at(camera, box, 1.f, key.time);
    CHECK(glm::distance(view.position, key.position) < 1e-5f);
    CHECK(glm::distance(view.target, key.target) < 1e-5f);
    CHECK(view.vertical_fov == Approx(key.vertical_fov));
  }
  CHECK(view_at(camera, box, 1.f, 0.).position == camera.keyframes.front().position);
  CHECK(view_at(camera, box, 1.f, 9.).position == camera.keyframes.back().position);

  glm::vec3 before = camera.keyframes.front().position;
  for (double time = 1.; time <= 4.; time += 0.01) {
    const gl::View view = view_at(camera, box, 1.f, time);
    CHECK(view.position.x >= before.x - 1e-5f);
    CHECK(view.position.x <= 2.f + 1e-5f);
    CHECK(view.position.y >= before.y - 1e-5f);
    CHECK(glm::distance(view.position, before) < 0.05f);  // no jumps
    before = view.position;
  }
  const float just_after = view_at(camera, box, 1.f, 1.01).position.x;
  CHECK(just_after < 0.01f);  // it starts from rest
}

TEST_CASE("a still camera is where it is put at any time") {
  CameraSettings camera;
  camera.keyframes = {{0.f, {1, 2, 3}, {0, 0, 0}, {0, 1, 0}, 45.f}};
  for (const double time : {-1., 0., 5.})
    CHECK(view_at(camera, {}, 1.f, time).position == glm::vec3(1.f, 2.f, 3.f));
}

TEST_CASE("obstacle meshes are closed, face outward and hold the shape's volume") {
  const std::vector<sim::Shape> shapes{sim::Box{{-1.f, 0.f, 2.f}, {1.f, 0.5f, 3.f}},
                                       sim::Sphere{{1.f, 2.f, 3.f}, 0.5f},
                                       sim::Cylinder{{0.f, 0.f, 0.f}, {0.f, 1.f, 0.f}, 0.3f},
                                       sim::Cylinder{{1.f, 0.f, 0.f}, {0.f, 0.5f, 2.f}, 0.3f},
                                       sim::Capsule{{0.f, 0.f, 0.f}, {0.f, 1.f, 0.f}, 0.3f},
                                       sim::Capsule{{1.f, 0.f, 0.f}, {0.f, 0.5f, 2.f}, 0.3f},
                                       sim::Cone{{1.f, 0.f, 0.f}, {0.f, 0.5f, 2.f}, 0.3f, 0.6f}};
  for (const sim::Shape& shape : shapes) {
    INFO("shape " << shape.index());
    const Mesh mesh = mesh_of(shape);
    check_closed(mesh);
    CHECK(volume_inside(mesh) == Approx(sim::volume_of(shape)).epsilon(0.01));
  }
  CHECK(mesh_of(shapes[0]).triangles.size() == 12);
}

TEST_CASE("no obstacles make an empty mesh, several are put together") {
  CHECK(tessellate({}).triangles.empty());
  const std::vector<sim::Obstacle> two{{sim::Box{}}, {sim::Sphere{}}};
  CHECK(tessellate(two).triangles.size() ==
        mesh_of(sim::Box{}).triangles.size() + mesh_of(sim::Sphere{}).triangles.size());
}

}  // namespace app_camera_tests
