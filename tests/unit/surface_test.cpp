#include "render/surface/surface.hpp"

#include <omp.h>

#include <catch2/catch.hpp>
#include <cstring>
#include <limits>

#include "surface_support.hpp"

namespace surface_tests {

using namespace spindrift;
using namespace spindrift::surface;
using namespace spindrift::test;

namespace {

constexpr float d = 0.02f;  // spacing, m

Mesh mesh_of(const Points& points, const SurfaceSettings& settings = {}) {
  return reconstruct_surface(points, d, settings);
}

SurfaceSettings with_cell_size(float cell_size) {
  SurfaceSettings settings;
  settings.cell_size = cell_size;
  return settings;
}

// A pool with waves, a sheet one layer thick and spray.
Points splash() {
  Points points = box_of_particles({30, 8, 20}, d, 0.25f, 7);
  for (glm::vec3 p : box_of_particles({12, 1, 12}, d, 0.1f, 8))
    points.push_back(p + glm::vec3(5.0f, 12.0f, 4.0f) * d);
  for (const glm::vec3& p : random_cloud(150, 30.0f * d, 9))
    points.push_back(p + glm::vec3(15.0f, 20.0f, 10.0f) * d);
  return points;
}

template <typename T>
bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

float worst_normal_length(const Mesh& mesh) {
  float worst = 0.0f;
  for (const glm::vec3& n : mesh.normals)
    worst = std::max(worst, std::abs(glm::length(n) - 1.0f));
  return worst;
}

}  // namespace

TEST_CASE("no particles give an empty mesh") {
  const Mesh mesh = mesh_of({});
  CHECK(mesh.vertices.empty());
  CHECK(mesh.normals.empty());
  CHECK(mesh.triangles.empty());
}

TEST_CASE("one particle gives one round drop of about its own volume, wherever it lies") {
  for (const glm::vec3& p : random_cloud(20, 1.0f, 4)) {
    const Mesh mesh = mesh_of({p}, with_cell_size(0.25f));
    REQUIRE(topology_fault(mesh) == "");
    CHECK(piece_count(mesh) == 1);
    CHECK(volume(mesh) == Approx(d * d * d).epsilon(0.2));
    for (const glm::vec3& v : mesh.vertices)
      CHECK(glm::distance(v, p) == Approx(0.62f * d).epsilon(0.15));
  }
}

TEST_CASE("a drop is seen with the default cells, wherever it lies") {
  for (const glm::vec3& p : random_cloud(200, 1.0f, 5)) {
    const Mesh mesh = mesh_of({p});
    REQUIRE(piece_count(mesh) == 1);
    CHECK(volume(mesh) > 0.4 * d * d * d);
  }
}

TEST_CASE("random clouds give closed and manifold meshes") {
  // From spray to a crowd: the crossing patterns of all kinds of cubes.
  for (unsigned seed = 0; seed < 12; ++seed) {
    const float edge = (6.0f + 2.0f * float(seed)) * d;
    SurfaceSettings settings = with_cell_size(seed % 3 == 0 ? 1.0f : 0.5f);
    settings.smoothing = seed % 2 == 0 ? 0 : 10;
    settings.kernel_radius = seed % 4 == 0 ? 1.5f : 2.5f;
    INFO("seed " << seed);
    const Mesh mesh = mesh_of(random_cloud(800, edge, seed), settings);
    CHECK(topology_fault(mesh) == "");
    CHECK(worst_normal_length(mesh) < 1e-5f);
  }
}

TEST_CASE("splashes, sheets, balls and blocks give closed and manifold meshes") {
  CHECK(topology_fault(mesh_of(splash())) == "");
  CHECK(topology_fault(mesh_of(box_of_particles({30, 1, 30}, d))) == "");
  CHECK(topology_fault(mesh_of(sphere_of_particles(5.0f * d, d), with_cell_size(1.0f))) == "");
  CHECK(topology_fault(mesh_of(box_of_particles(glm::ivec3(12), d), with_cell_size(0.3f))) == "");
  // Nodes that lie exactly on particles and exactly between them.
  CHECK(topology_fault(mesh_of(box_of_particles({16, 8, 4}, d), with_cell_size(1.0f))) == "");
}

TEST_CASE("particles at one place give a closed mesh") {
  const Mesh mesh = mesh_of(Points(50, glm::vec3(0.1f)));
  CHECK(topology_fault(mesh) == "");
  CHECK(piece_count(mesh) == 1);
}

TEST_CASE("drops merge when they touch and stay apart when they do not") {
  for (float gap = 0.2f; gap < 4.0f; gap += 0.1f) {
    INFO("gap " << gap);
    const Mesh mesh = mesh_of({{0.0f, 0.0f, 0.0f}, {gap * d, 0.3f * d, 0.1f * d}});
    CHECK(topology_fault(mesh) == "");
    if (gap < 1.0f)
      CHECK(piece_count(mesh) == 1);
    if (gap > 2.0f)
      CHECK(piece_count(mesh) == 2);
  }
}

TEST_CASE("a block of particles has their volume, whatever the cell size") {
  const Points points = box_of_particles(glm::ivec3(20), d);
  for (const float cell_size : {0.3f, 0.5f, 0.8f, 1.0f}) {
    INFO("cell size " << cell_size);
    CHECK(volume(mesh_of(points, with_cell_size(cell_size))) ==
          Approx(8000.0 * d * d * d).epsilon(0.03));
  }
}

TEST_CASE("a sphere of particles has its volume, whatever the cell size") {
  const float radius = 10.0f * d;
  const Points points = sphere_of_particles(radius, d);
  for (const float cell_size : {0.3f, 0.5f, 0.8f, 1.0f}) {
    INFO("cell size " << cell_size);
    CHECK(volume(mesh_of(points, with_cell_size(cell_size))) ==
          Approx(4.0 / 3.0 * 3.14159265 * radius * radius * radius).epsilon(0.03));
  }
}

TEST_CASE("smoothing takes no liquid from a block nor from a drop, however long and coarse") {
  const Points block = box_of_particles({15, 20, 10}, d, 0.15f);
  const Points drop = box_of_particles(glm::ivec3(4), d, 0.15f, 2);
  for (const Points& points : {block, drop})
    for (const float cell_size : {0.3f, 0.55f, 1.0f}) {
      SurfaceSettings settings = with_cell_size(cell_size);
      settings.smoothing = 0;
      const double rough = volume(mesh_of(points, settings));
      for (const int smoothing : {3, 10, 100}) {
        settings.smoothing = smoothing;
        const Mesh mesh = mesh_of(points, settings);
        INFO(points.size() << " particles, cell size " << cell_size << ", smoothing " << smoothing);
        CHECK(volume(mesh) == Approx(rough).epsilon(0.012));
        CHECK(topology_fault(mesh) == "");
        if (points.size() == block.size())
          CHECK(volume(mesh) == Approx(double(points.size()) * d * d * d).epsilon(0.045));
      }
    }
}

TEST_CASE("normals are unit vectors along a sphere's radii") {
  const Mesh mesh = mesh_of(sphere_of_particles(10.0f * d, d));
  CHECK(worst_normal_length(mesh) < 1e-5f);
  double mean = 0.0;
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
    const float cosine = glm::dot(mesh.normals[v], glm::normalize(mesh.vertices[v]));
    CHECK(cosine > 0.97f);
    mean += cosine;
  }
  CHECK(mean / double(mesh.vertices.size()) > 0.997);
}

TEST_CASE("triangles wind counter-clockwise seen from outside") {
  const Mesh mesh = mesh_of(sphere_of_particles(6.0f * d, d));
  for (const glm::uvec3& t : mesh.triangles) {
    const glm::vec3 a = mesh.vertices[t.x];
    const glm::vec3 normal = glm::cross(mesh.vertices[t.y] - a, mesh.vertices[t.z] - a);
    CHECK(glm::dot(normal, a) >= 0.0f);
  }
}

TEST_CASE("the surface of a resting pool is flat and half a spacing above the top particles") {
  for (const float shift : {0.0f, 0.13f, 0.37f}) {
    Points points = box_of_particles({32, 8, 32}, d);
    for (glm::vec3& p : points)
      p.y += shift * d;
    const Mesh mesh = mesh_of(points);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
      const glm::vec3 p = mesh.vertices[v] / d;
      if (p.x < 5 || p.x > 27 || p.z < 5 || p.z > 27 || p.y < 6)
        continue;
      CHECK(p.y == Approx(8.0f + shift).margin(0.05));
      CHECK(mesh.normals[v].y > 0.999f);
    }
  }
}

TEST_CASE("a sheet one layer thick is whole and about one spacing thick") {
  for (const float jitter : {0.0f, 0.2f}) {
    const Mesh mesh = mesh_of(box_of_particles({30, 1, 30}, d, jitter));
    CHECK(piece_count(mesh) == 1);
    CHECK(mesh.vertices.size() == mesh.triangles.size() / 2 + 2);  // Euler: no holes
    CHECK(volume(mesh) == Approx(900.0 * d * d * d).epsilon(0.2));
  }
}

TEST_CASE("the mesh has the same bytes for every number of threads") {
  const Points points = splash();
  const int before = omp_get_max_threads();
  omp_set_num_threads(1);
  const Mesh one = mesh_of(points);
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    const Mesh mesh = mesh_of(points);
    CHECK(same_bytes(mesh.vertices, one.vertices));
    CHECK(same_bytes(mesh.normals, one.normals));
    CHECK(same_bytes(mesh.triangles, one.triangles));
  }
  omp_set_num_threads(before);
}

TEST_CASE("a particle far away costs no more than a drop") {
  Points points = box_of_particles(glm::ivec3(10), d);
  const Mesh near = mesh_of(points);
  points.push_back({10000.0f * d, -10000.0f * d, 9000.0f * d});
  const Mesh both = mesh_of(points);
  CHECK(topology_fault(both) == "");
  CHECK(piece_count(both) == 2);
  CHECK(both.vertices.size() < near.vertices.size() + 100);
}

TEST_CASE("particles at the farthest place allowed give a closed mesh") {
  const float edge = 0.99f * float(1 << 19) * d;
  const Mesh mesh = mesh_of({glm::vec3(edge), glm::vec3(-edge)});
  CHECK(topology_fault(mesh) == "");
  CHECK(piece_count(mesh) == 2);
}

TEST_CASE("a particle without a finite position is named") {
  Points points = box_of_particles(glm::ivec3(4), d);
  points[37].y = std::numeric_limits<float>::quiet_NaN();
  CHECK_THROWS_WITH(mesh_of(points), Catch::Contains("particle 37") && Catch::Contains("finite"));
  points[21].z = -std::numeric_limits<float>::infinity();
  CHECK_THROWS_WITH(mesh_of(points), Catch::Contains("particle 21"));
  CHECK_THROWS_AS(mesh_of(points), std::invalid_argument);
}

TEST_CASE("a particle beyond what a float can resolve is named with the limit") {
  Points points = box_of_particles(glm::ivec3(4), d);
  points[5].x = 1e30f;
  CHECK_THROWS_WITH(mesh_of(points), Catch::Contains("particle 5") && Catch::Contains("within"));
}

TEST_CASE("settings out of range are errors that tell the range") {
  const Points points{glm::vec3(0.0f)};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  for (const float spacing : {0.0f, -1.0f, nan, std::numeric_limits<float>::infinity()})
    CHECK_THROWS_AS(reconstruct_surface(points, spacing, {}), std::invalid_argument);

  SurfaceSettings settings;
  settings.cell_size = 3.0f;
  CHECK_THROWS_WITH(mesh_of(points, settings), "surface cell_size is 3; it must lie in 0.1 ... 1");
  settings = {};
  settings.iso_value = nan;
  CHECK_THROWS_WITH(mesh_of(points, settings), Catch::Contains("iso_value"));
  settings = {};
  settings.kernel_radius = 1.0f;
  CHECK_THROWS_WITH(mesh_of(points, settings), Catch::Contains("1.5 ... 4"));
  settings = {};
  settings.smoothing = -1;
  CHECK_THROWS_WITH(mesh_of(points, settings), Catch::Contains("0 ... 100"));
}

}  // namespace surface_tests
