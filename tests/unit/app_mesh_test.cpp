// Mesh files, from the file to the solid in its place, and what is said about bad ones.
#include <fmt/format.h>

#include <catch2/catch.hpp>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/checks/estimate.hpp"
#include "app/checks/scene_meshes.hpp"
#include "app/draw/obstacle_mesh.hpp"
#include "app/mesh_files/mesh_file.hpp"
#include "app/scene/scene.hpp"
#include "mesh_support.hpp"
#include "output_support.hpp"
#include "render/output/output.hpp"
#include "sim/geometry/mesh/closed_surface.hpp"
#include "sim/geometry/shape.hpp"

namespace app_mesh_tests {

using namespace spindrift;
using namespace spindrift::app;
using namespace spindrift::geometry;
using namespace spindrift::test;
using output_test::TemporaryFolder;

namespace {

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

std::string obj_text(const sim::TriangleSurface& surface) {
  std::string text = "# a comment\nmtllib nowhere.mtl\no thing\n";
  for (const glm::vec3& v : surface.vertices)
    text += fmt::format("v {} {} {}\n", v.x, v.y, v.z);
  for (const glm::uvec3& t : surface.triangles)
    text += fmt::format("f {} {} {}\n", t.x + 1, t.y + 1, t.z + 1);
  return text;
}

/// Every triangle with corners, normals and texture coordinates of its own.
std::string obj_text_unshared(const sim::TriangleSurface& surface) {
  std::string text = "vt 0 0\n";
  int corner = 0, face = 0;
  for (const glm::uvec3& t : surface.triangles) {
    text += fmt::format("vn {} 1 0\n", ++face);
    std::string line = "f";
    for (int k = 0; k < 3; ++k) {
      const glm::vec3& v = surface.vertices[t[k]];
      text += fmt::format("v {} {} {}\n", v.x, v.y, v.z);
      line += fmt::format(" {}/1/{}", ++corner, face);
    }
    text += line + "\n";
  }
  return text;
}

std::string ply_text(const sim::TriangleSurface& surface) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      surface.vertices.size(), surface.triangles.size());
  for (const glm::vec3& v : surface.vertices)
    text += fmt::format("{} {} {}\n", v.x, v.y, v.z);
  for (const glm::uvec3& t : surface.triangles)
    text += fmt::format("3 {} {} {}\n", t.x, t.y, t.z);
  return text;
}

/// The corners of all triangles in order, which is what a file must keep.
std::vector<glm::vec3> corners(const sim::TriangleSurface& surface) {
  std::vector<glm::vec3> all;
  for (const glm::uvec3& t : surface.triangles)
    for (int k = 0; k < 3; ++k)
      all.push_back(surface.vertices[t[k]]);
  return all;
}

/// A scene in the folder with this mesh as an obstacle; `place` is more of its keys.
Scene scene_with(const TemporaryFolder& folder, const std::string& file,
                 const std::string& place = "") {
  const std::string text = fmt::format(
      R"({{"fluid": {{"spacing": 0.05, "volumes": [{{"box": {{"min": [0,0,0], "max": [1.2,1,0.8]}}}}]}},
          "obstacles": [{{"mesh": {{"file": "{}"{}}}}}]}})",
      file, place);
  return parse_scene(text, folder / "scene.json");
}

/// The message for such a scene; empty if it is accepted.
std::string complaint(const TemporaryFolder& folder, const std::string& file,
                      const std::string& place = "") {
  try {
    scene_with(folder, file, place);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "";
}

const sim::MeshBody& body_of(const Scene& scene) {
  return *std::get<sim::TriangleMesh>(scene.simulation.obstacles.at(0).shape).body;
}

sim::TriangleSurface without_triangles(sim::TriangleSurface mesh, std::size_t count) {
  mesh.triangles.resize(mesh.triangles.size() - count);
  return mesh;
}

}  // namespace

TEST_CASE("OBJ and PLY files give the triangles that were written") {
  const TemporaryFolder folder;
  const auto ball = ball_mesh({1, 2, 3}, 0.5f, 2);
  write_text(folder / "ball.obj", obj_text(ball));
  write_text(folder / "unshared.OBJ", obj_text_unshared(ball));
  write_text(folder / "text.ply", ply_text(ball));
  output::write_ply(folder / "binary.ply", Mesh{ball.vertices, {}, ball.triangles});
  for (const char* name : {"ball.obj", "unshared.OBJ", "text.ply", "binary.ply"}) {
    INFO(name);
    const auto read = closed_surface(read_mesh_file(folder / name));
    CHECK(corners(read) == corners(ball));
    CHECK(read.vertices.size() == ball.vertices.size());
  }
}

TEST_CASE("polygons, several objects, and points and lines between them are read") {
  const TemporaryFolder folder;
  write_text(folder / "boxes.obj", R"(
o first
v 0 0 0
v 1 0 0
v 0 1 0
v 1 1 0
v 0 0 1
v 1 0 1
v 0 1 1
v 1 1 1
p 1
l 1 2
f 1 5 7 3
f 2 4 8 6
f 1 2 6 5
f 3 7 8 4
f 1 3 4 2
o second
v 5 0 0
f 5 6 8 7
)");
  const auto box = closed_surface(read_mesh_file(folder / "boxes.obj"));
  CHECK(box.triangles.size() == 12);
  CHECK(enclosed_volume(box) == Approx(1));
}

TEST_CASE("a mesh is scaled, turned about x, y and z, and moved, in this order") {
  const TemporaryFolder folder;
  write_text(folder / "box.obj", obj_text(box_mesh({0, 0, 0}, {1, 2, 3})));
  const Scene scene = scene_with(
      folder, "box.obj", R"(, "scale": 0.1, "rotate": [90, 90, 0], "translate": [1, 0.5, 0.4])");
  // (1, 2, 3) about x becomes (1, −3, 2), and about y then (2, −3, −1).
  const sim::Box bounds = body_of(scene).bounds();
  CHECK(glm::distance(bounds.min, {1, 0.2f, 0.3f}) < 1e-6f);
  CHECK(glm::distance(bounds.max, {1.2f, 0.5f, 0.4f}) < 1e-6f);
  const auto resolved = to_json(scene)["obstacles"][0]["mesh"];
  CHECK(resolved["file"] == "box.obj");
  CHECK(resolved["scale"] == 0.1);
  CHECK(to_json(scene_with(folder, "box.obj"))["obstacles"][0]["mesh"]["scale"] == 1.);
  CHECK(body_of(scene_with(folder, (folder / "box.obj").string())).bounds().max.z == 3);
}

TEST_CASE("triangles that wind differently are turned to face outward") {
  auto ball = ball_mesh(glm::vec3(0), 1, 2);
  const double volume = enclosed_volume(ball);
  SECTION("all of them") {
    for (auto& t : ball.triangles)
      std::swap(t.y, t.z);
  }
  SECTION("one of three") {
    for (std::size_t k = 0; k < ball.triangles.size(); k += 3)
      std::swap(ball.triangles[k].y, ball.triangles[k].z);
  }
  const auto turned = closed_surface(ball);
  CHECK(enclosed_volume(turned) == Approx(volume));
  for (const glm::uvec3& t : turned.triangles) {
    const glm::vec3 a = turned.vertices[t.x], b = turned.vertices[t.y], c = turned.vertices[t.z];
    CHECK(glm::dot(glm::cross(b - a, c - a), a + b + c) > 0);
  }
}

TEST_CASE("a cavity stays one") {
  const auto hollow = joined(box_mesh(glm::vec3(0), glm::vec3(1)),
                             box_mesh(glm::vec3(0.25f), glm::vec3(0.75f)), true);
  CHECK(enclosed_volume(closed_surface(hollow)) == Approx(1 - 0.125));
}

TEST_CASE("a mesh with an inner shell is hollow whichever way that is turned, and is told of") {
  const TemporaryFolder folder;
  for (const bool turned : {false, true}) {
    const auto tank = joined(box_mesh(glm::vec3(0), {1.6f, 1.2f, 1}),
                             box_mesh(glm::vec3(0.1f), {1.5f, 1.1f, 0.9f}), turned);
    write_text(folder / "tank.obj", obj_text(tank));
    const Scene scene = scene_with(folder, "tank.obj");
    const sim::Shape& shape = scene.simulation.obstacles[0].shape;
    CHECK(sim::is_inside(shape, glm::vec3(0.05f)));
    CHECK_FALSE(sim::is_inside(shape, glm::vec3(0.5f)));
    const std::vector<Diagnostic> warnings = mesh_warnings(scene);
    REQUIRE(warnings.size() == 1);
    CHECK(warnings[0].path == "obstacles[0].mesh");
    CHECK(warnings[0].message ==
          "tank.obj has 1 inner shell: what is within it is hollow, whichever way triangles face");
  }
  write_text(folder / "box.obj", obj_text(box_mesh({2, 0, 0}, {3, 1, 0.8f})));
  CHECK(mesh_warnings(scene_with(folder, "box.obj")).empty());
}

TEST_CASE("boxes that touch at an edge are closed") {
  const auto two = joined(box_mesh({0, 0, 0}, {1, 1, 1}), box_mesh({1, 1, 0}, {2, 2, 1}));
  CHECK(enclosed_volume(closed_surface(two)) == Approx(2));
}

TEST_CASE("bad mesh files are refused with their place, the reason and what to do") {
  const TemporaryFolder folder;
  const auto box = box_mesh({2, 0, 0}, {3, 1, 0.8f});
  write_text(folder / "bunny.obj", obj_text(box));
  write_text(folder / "stone.stl", "solid\nendsolid\n");
  write_text(folder / "torn.obj", obj_text(without_triangles(box, 1)));
  write_text(folder / "lid_off.ply", ply_text(without_triangles(box, 2)));
  write_text(folder / "points.obj", "v 0 0 0\nv 1 0 0\np 1 2\n");
  write_text(folder / "empty.ply", "");
  write_text(folder / "words.obj", "These are words, not a mesh.\n");
  write_text(folder / "short.ply", ply_text(box).substr(0, 300));
  write_text(folder / "nan.ply", [&] {
    auto broken = box;
    broken.vertices[3].y = std::nanf("");
    return ply_text(broken);
  }());
  auto flat = box;
  for (glm::vec3& v : flat.vertices)
    v.z = 0;
  write_text(folder / "flat.obj", obj_text(flat));
  std::filesystem::create_directory(folder / "folder.obj");

  const auto says = [&](const char* file, const std::vector<std::string>& fragments,
                        const std::string& place = "") {
    const std::string message = complaint(folder, file, place);
    INFO(file << ": " << message);
    CHECK(message.find("scene.json:2:") != std::string::npos);
    CHECK(message.find("obstacles[0].mesh") != std::string::npos);
    for (const std::string& fragment : fragments) {
      INFO(fragment);
      CHECK(message.find(fragment) != std::string::npos);
    }
  };
  says("buny.obj", {"mesh.file", "buny.obj: there is no such file", "did you mean \"bunny.obj\"?"});
  says("sub/bunny.obj", {"sub/bunny.obj: there is no such file"});
  says("stone.stl", {"stone.stl: is not named .obj or .ply"});
  says("torn.obj", {"torn.obj: is not closed: 3 edges are without a neighbour", "close the holes"});
  says("lid_off.ply", {"is not closed: 4 edges are without", "[2, 0, 0.8]"});
  says("points.obj", {"points.obj: has no triangles"});
  says("empty.ply", {"empty.ply: is not a PLY"});
  says("words.obj", {"words.obj: has no triangles"});
  says("short.ply", {"short.ply: line", "is cut short"});
  says("nan.ply", {"nan.ply: line 13: nan is not a coordinate"});
  says("flat.obj", {"encloses no volume"});
  says("folder.obj", {"folder.obj: is a folder, not a file"});
  says("bunny.obj", {"500 m wide; accepted: 0.05 ... 32 m", "scale"}, R"(, "scale": 500)");
  says("bunny.obj", {"0.01 m wide", "scale"}, R"(, "scale": 0.01)");
  says("bunny.obj", {"mesh.rotate[1]", "-360 ... 360 degrees"}, R"(, "rotate": [0, 400, 0])");
  says("bunny.obj", {"mesh.rotat", "did you mean \"rotate\""}, R"(, "rotat": [0, 0, 0])");
  CHECK(complaint(folder, "bunny.obj") == "");
}

TEST_CASE("surfaces that no turning closes are refused") {
  // A Möbius strip closed over by nothing has open edges; a Klein bottle has none, and one side.
  sim::TriangleSurface klein;
  const unsigned n = 8;
  for (unsigned j = 0; j < n; ++j)
    for (unsigned i = 0; i < n; ++i)
      klein.vertices.push_back({i, j, static_cast<float>((i * 7 + j * 3) % 5)});
  const auto at = [&](unsigned i, unsigned j) {
    return j == n ? (n - i) % n : j * n + i % n;  // the last row meets the first one mirrored
  };
  for (unsigned j = 0; j < n; ++j) {
    for (unsigned i = 0; i < n; ++i) {
      klein.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      klein.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  CHECK_THROWS_WITH(closed_surface(klein), Catch::Contains("one side only"));
  auto fin = joined(box_mesh(glm::vec3(0), glm::vec3(1)), {});
  fin.vertices.push_back({2, 2, 0});
  fin.triangles.push_back({0, 1, 8});
  CHECK_THROWS_WITH(closed_surface(fin), Catch::Contains("3 edges"));
  CHECK_THROWS_WITH(closed_surface({}), Catch::Contains("no triangles"));
}

TEST_CASE("the hash depends on what a mesh file holds, not on its name") {
  const TemporaryFolder folder;
  const auto box = box_mesh({2, 0, 0}, {3, 1, 0.8f});
  write_text(folder / "a.obj", obj_text(box));
  write_text(folder / "b.ply", ply_text(box));
  const std::string hash = simulation_hash(scene_with(folder, "a.obj"));
  CHECK(hash == simulation_hash(scene_with(folder, "b.ply")));
  CHECK(hash != simulation_hash(scene_with(folder, "a.obj", R"(, "translate": [0, 0.1, 0])")));
  auto other = box;
  other.vertices[7].y = 1.01f;
  write_text(folder / "a.obj", obj_text(other));
  CHECK(hash != simulation_hash(scene_with(folder, "a.obj")));
}

TEST_CASE("a mesh fills with liquid like the shape that it stands for") {
  const TemporaryFolder folder;
  write_text(folder / "ball.obj", obj_text(ball_mesh({1, 1, 1}, 0.4f, 4)));
  const auto scene_of = [&](const std::string& shape) {
    return parse_scene(R"({"fluid": {"spacing": 0.05, "volumes": [{)" + shape +
                           R"(, "velocity": [0, -1, 0]}]}, "domain": {"max": [2, 2, 2]}})",
                       folder / "scene.json");
  };
  const auto mesh = estimate(scene_of(R"("mesh": {"file": "ball.obj"})"), 1);
  const auto sphere = estimate(scene_of(R"("sphere": {"center": [1, 1, 1], "radius": 0.4})"), 1);
  CHECK(static_cast<double>(mesh.particles) ==
        Approx(static_cast<double>(sphere.particles)).epsilon(0.04));
  const sim::Shape ball = solid(ball_mesh({1, 1, 1}, 0.4f, 4), 0.05f);
  CHECK(sim::volume_of(ball) == Approx(sim::volume_of(sim::Sphere{{1, 1, 1}, 0.4f})).epsilon(0.01));
  CHECK(sim::area_of(ball) == Approx(sim::area_of(sim::Sphere{{1, 1, 1}, 0.4f})).epsilon(0.01));
}

TEST_CASE("a drawn mesh is smooth where it is round and sharp at its edges") {
  const auto drawn = [](const sim::TriangleSurface& surface) {
    const std::vector<sim::Obstacle> obstacles{{solid(surface, 0.1f)}};
    return tessellate(obstacles);
  };
  const auto ball = ball_mesh({1, 2, 3}, 0.5f, 3);
  const Mesh round = drawn(ball);
  CHECK(round.vertices.size() == ball.vertices.size());
  for (std::size_t k = 0; k < round.vertices.size(); ++k) {
    CHECK(glm::dot(round.normals[k], glm::normalize(round.vertices[k] - glm::vec3(1, 2, 3))) >
          0.995f);
  }
  const Mesh sharp = drawn(box_mesh(glm::vec3(0), glm::vec3(1)));
  CHECK(sharp.triangles.size() == 12);
  CHECK(sharp.vertices.size() == 24);
  for (const glm::uvec3& t : sharp.triangles) {
    const glm::vec3 a = sharp.vertices[t.x], b = sharp.vertices[t.y], c = sharp.vertices[t.z];
    for (int k = 0; k < 3; ++k)
      CHECK(glm::dot(sharp.normals[t[k]], glm::normalize(glm::cross(b - a, c - a))) > 0.9999f);
  }
}

}  // namespace app_mesh_tests
