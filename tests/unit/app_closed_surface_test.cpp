// What is inside a mesh of several parts, whichever way these are turned.
#include <fmt/format.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <string>
#include <vector>

#include "app/mesh_files/mesh_readers.hpp"
#include "mesh_support.hpp"
#include "render/output/input_file.hpp"
#include "sim/geometry/mesh/closed_surface.hpp"

namespace app_closed_surface_tests {

using namespace spindrift;
using namespace spindrift::app;
using namespace spindrift::geometry;
using namespace spindrift::test;
using Catch::Matchers::Contains;

namespace {

/// Parts, the k-th turned inside out where bit k of `turned` says so.
geometry::TriangleSurface turned_parts(const std::vector<geometry::TriangleSurface>& parts,
                                       unsigned turned) {
  geometry::TriangleSurface all;
  for (std::size_t k = 0; k < parts.size(); ++k)
    all = joined(all, parts[k], (turned >> k & 1) != 0);
  return all;
}

/// Whether the body that a mesh stands for is at a place.
bool is_inside(const geometry::TriangleSurface& closed, const glm::vec3& place) {
  return geometry::TriangleTree(closed).winding_number(place) > 0;
}

geometry::TriangleSurface box(float low, float high) {
  return box_mesh(glm::vec3(low), glm::vec3(high));
}

}  // namespace

TEST_CASE("a shell within a shell is a cavity, and one within that a body, however turned") {
  for (unsigned turned = 0; turned < 8; ++turned) {
    const auto mesh = closed_surface(turned_parts({box(0, 7), box(1, 6), box(2, 5)}, turned));
    CHECK(enclosed_volume(mesh) == Approx(343 - 125 + 27));
    CHECK(inner_shells(mesh) == 1);
    CHECK(is_inside(mesh, glm::vec3(0.5f)));
    CHECK_FALSE(is_inside(mesh, glm::vec3(1.5f)));
    CHECK(is_inside(mesh, glm::vec3(3.5f)));
  }
}

TEST_CASE("parts beside each other in a cavity are bodies of their own, and two cavities are two") {
  for (unsigned turned = 0; turned < 32; ++turned) {
    const auto mesh = closed_surface(
        turned_parts({box(0, 9), box(1, 4), box(5, 8), box(2, 3), box(10, 11)}, turned));
    CHECK(enclosed_volume(mesh) == Approx(729 - 27 - 27 + 1 + 1));
    CHECK(inner_shells(mesh) == 2);
    CHECK(is_inside(mesh, glm::vec3(4.5f)));
    CHECK_FALSE(is_inside(mesh, glm::vec3(6)));
    CHECK(is_inside(mesh, glm::vec3(2.5f)));
    CHECK(is_inside(mesh, glm::vec3(10.5f)));
  }
}

TEST_CASE("parts that overlap are one body, however turned") {
  for (unsigned turned = 0; turned < 4; ++turned) {
    const auto mesh = closed_surface(turned_parts({box(0, 2), box(1, 3)}, turned));
    CHECK(inner_shells(mesh) == 0);
    for (const float place : {0.5f, 1.5f, 2.5f})
      CHECK(is_inside(mesh, glm::vec3(place)));
    CHECK_FALSE(is_inside(mesh, {0.5f, 2.5f, 0.5f}));
  }
  // Cavities that overlap are one as well.
  for (unsigned turned = 0; turned < 8; ++turned) {
    const auto mesh = closed_surface(turned_parts({box(0, 9), box(1, 5), box(4, 8)}, turned));
    for (const float place : {1.5f, 4.5f, 7.5f})
      CHECK_FALSE(is_inside(mesh, glm::vec3(place)));
    CHECK(is_inside(mesh, glm::vec3(0.5f)));
  }
}

TEST_CASE("parts that touch are bodies beside each other, however turned") {
  const auto first = box_mesh({0, 0, 0}, {1, 1, 1});
  for (unsigned turned = 0; turned < 8; ++turned) {
    // At an edge, at a face with the same corners, and at a part of a face.
    const auto edge = box_mesh({1, 1, 0}, {2, 2, 1}), face = box_mesh({1, 0, 0}, {2, 1, 1}),
               part = box_mesh({-1, 0.2f, 0.2f}, {0, 0.8f, 0.8f});
    for (const auto& other : {edge, face}) {
      const auto mesh = closed_surface(turned_parts({first, other, part}, turned));
      CHECK(enclosed_volume(mesh) == Approx(2.36));
      CHECK(inner_shells(mesh) == 0);
      CHECK(is_inside(mesh, glm::vec3(0.5f)));
      CHECK(is_inside(mesh, {-0.5f, 0.5f, 0.5f}));
    }
  }
}

TEST_CASE("single triangles may be turned anywhere, also where boxes meet at an edge") {
  const auto two = joined(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 1, 0}, {2, 2, 1}));
  for (std::size_t every = 1; every < 6; ++every) {
    auto mesh = two;
    for (std::size_t k = 0; k < mesh.triangles.size(); k += every)
      std::swap(mesh.triangles[k].x, mesh.triangles[k].y);
    CHECK(enclosed_volume(closed_surface(mesh)) == Approx(2));
  }
}

// Which of four triangles at an edge belong together followed from the numbers of their vertices.
TEST_CASE("a surface that meets itself at edges is the same when it is made closed again") {
  const auto once = closed_surface(
      read_obj(output::read_file(SOURCE_DIR "/tests/fuzz/corpus/mesh/shared_edges.obj")));
  const auto again = closed_surface(once);
  CHECK(inner_shells(once) == 1);
  CHECK(inner_shells(again) == 1);
  CHECK(enclosed_volume(again) == Approx(enclosed_volume(once)));
}

TEST_CASE("a mesh that is there twice counts once, and a face between two bodies not at all") {
  for (const bool turned : {false, true}) {
    const auto mesh = closed_surface(joined(box(0, 1), box(0, 1), turned));
    CHECK(mesh.triangles.size() == 12);
    CHECK(enclosed_volume(mesh) == Approx(1));
  }
}

TEST_CASE("many parts are told apart in time") {
  geometry::TriangleSurface mesh = box(-1, 40);
  for (int k = 0; k < 8000; ++k) {
    const auto stone = box_mesh(glm::vec3(k % 20, k / 20 % 20, k / 400),
                                glm::vec3(k % 20, k / 20 % 20, k / 400) + 0.5f);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), stone.vertices.begin(), stone.vertices.end());
    for (const glm::uvec3& t : stone.triangles)
      mesh.triangles.push_back(t + first);
  }
  const auto closed = closed_surface(mesh);
  CHECK(inner_shells(closed) == 8000);
  CHECK(enclosed_volume(closed) == Approx(41 * 41 * 41 - 1000));
}

TEST_CASE("many parts along one axis are told apart in time, whichever it is") {
  const int axis = GENERATE(0, 1, 2);
  geometry::TriangleSurface mesh = box(21001, 42001);
  for (int k = 0; k < 21000; ++k) {
    glm::vec3 low(0);
    low[axis] = static_cast<float>(k);
    const auto stone = box_mesh(low, low + 0.5f);
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), stone.vertices.begin(), stone.vertices.end());
    for (const glm::uvec3& t : stone.triangles)
      mesh.triangles.push_back(t + first);
  }
  // Two hundred million pairs that are looked at would be refused.
  CHECK(inner_shells(closed_surface(mesh)) == 0);
}

}  // namespace app_closed_surface_tests
