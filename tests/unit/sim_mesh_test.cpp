// Bodies of triangles against the shapes that they stand for.
#include <omp.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>

#include "mesh_support.hpp"
#include "sample_support.hpp"
#include "sim/boundary/contact.hpp"
#include "sim/geometry/shape.hpp"
#include "sim/start/fill.hpp"

namespace sim_mesh_tests {

using namespace spindrift::sim;
using namespace spindrift::test;

namespace {

constexpr float d = 0.05f;

glm::vec3 pushed(const Shape& shape, const glm::vec3& p) {
  return push_out(shape, p);
}

std::vector<glm::vec3> random_points(int count, float low, float high) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> anywhere(low, high);
  std::vector<glm::vec3> points(static_cast<std::size_t>(count));
  for (glm::vec3& p : points)
    p = {anywhere(random), anywhere(random), anywhere(random)};
  return points;
}

/// How far a point is below a box's faces, m; negative outside.
float depth_in_box(const Box& box, const glm::vec3& p) {
  const glm::vec3 depth = glm::min(p - box.min, box.max - p);
  return std::min({depth.x, depth.y, depth.z});
}

/// The samples lie half a spacing below the surface and are spread evenly over it; `below` is the
/// surface that they are on.
void check_samples(const TriangleSurface& surface, const std::vector<glm::vec3>& below) {
  const TriangleTree tree(surface);
  const auto samples = positions(sample_surface(solid(surface, d), d));
  float shallowest = 1, deepest = 0;
  for (const glm::vec3& p : samples) {
    shallowest = std::min(shallowest, tree.nearest(p).distance);
    deepest = std::max(deepest, tree.nearest(p).distance);
  }
  CHECK(shallowest > 0.49f * d);
  CHECK(deepest < 0.51f * d);
  const Spread s = spread(samples, below);
  CHECK(s.closest > 0.6f * d);
  CHECK(s.loneliest < 1.4f * d);
  CHECK(s.hole < 1.1f * d);
}

}  // namespace

TEST_CASE("a cube of triangles holds the same lattice as the box") {
  const Box box{{0.1f, 0.2f, 0.3f}, {0.6f, 0.9f, 1.3f}};
  auto expected = fill_shape(box, d), found = fill_shape(solid(box_mesh(box.min, box.max), d), d);
  REQUIRE(found.size() == expected.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    CHECK(glm::distance(found[k], expected[k]) < 1e-5f);
}

TEST_CASE("a ball of triangles holds as many particles as the sphere") {
  const glm::vec3 center(0.2f, 0.3f, 0.4f);
  const auto expected = fill_shape(Sphere{center, 0.5f}, d);
  const auto found = fill_shape(solid(ball_mesh(center, 0.5f, 4), d), d);
  const double volume = 4.18879 * 0.125 / (d * d * d);
  CHECK(static_cast<double>(expected.size()) == Approx(volume).epsilon(0.015));
  CHECK(static_cast<double>(found.size()) == Approx(volume).epsilon(0.015));
  for (const glm::vec3& p : found)
    CHECK(glm::distance(p, center) < 0.5f + 0.02f * d);
}

TEST_CASE("points are pushed out of a cube of triangles as out of the box") {
  const Box box{{0, 0, 0}, {1, 1, 1}};
  const Shape mesh = solid(box_mesh(box.min, box.max), d);
  for (const glm::vec3& p : random_points(20000, -0.2f, 1.2f)) {
    const float depth = depth_in_box(box, p);
    const glm::vec3 out = pushed(mesh, p);
    if (depth <= 0) {
      CHECK(out == p);
      continue;
    }
    if (depth > 0.15f * d)  // edges are rounded by less than that
      CHECK(out != p);
    CHECK(std::abs(depth_in_box(box, out)) < 0.15f * d);
    CHECK(glm::distance(p, out) < depth + 0.15f * d);
  }
}

TEST_CASE("points are pushed out of a ball of triangles as out of the sphere") {
  const glm::vec3 center(0.5f, 0.51f, 0.52f);
  const Shape mesh = solid(ball_mesh(center, 0.4f, 5), d);
  float worst = 0;
  for (const glm::vec3& p : random_points(20000, 0.f, 1.f)) {
    const float r = glm::distance(p, center);
    const glm::vec3 out = pushed(mesh, p);
    if (r >= 0.4f)
      CHECK(out == p);
    else if (r < 0.4f - 0.02f * d)
      worst = std::max(
          {worst, std::abs(glm::distance(out, center) - 0.4f), glm::distance(p, out) - (0.4f - r)});
  }
  CHECK(worst < 0.05f * d);
}

TEST_CASE("contact keeps a way on its side of a plate of triangles, however thin it is") {
  for (const float thickness : {0.005f * d, 0.1f * d}) {
    const Shape plate = solid(box_mesh({0, 0.5f - thickness, 0}, {1, 0.5f, 1}), d);
    const Solid wall = solid_of(plate);
    const ContactView contact{{0, 0, 0}, {1, 1, 1}, {&wall, 1, {}, d}};
    for (const float deep : {0.002f * d, 0.05f * d, 0.3f * d, 8 * d})
      for (const float aside : {0.f, 0.3f * d, 4 * d}) {
        CAPTURE(thickness / d, deep / d, aside / d);
        const Vec3<float> above{0.43f, 0.5f + 0.2f * d, 0.52f};
        CHECK(contact.resolve(above, {0.43f + aside, 0.5f - deep, 0.52f}).y >= 0.5f);
        const Vec3<float> below{0.43f, 0.5f - thickness - 0.2f * d, 0.52f};
        CHECK(contact.resolve(below, {0.43f + aside, 0.5f - thickness + deep, 0.52f}).y <=
              0.5f - thickness);
      }
  }
}

TEST_CASE("a point far inside is taken to the nearest surface, and far outside left alone") {
  const Shape mesh = solid(askew(box_mesh(glm::vec3(-1), glm::vec3(1))), d);
  const glm::vec3 away(0.013f, 0.017f, 0.011f);
  const glm::vec3 axis(0.36f, 0.48f, -0.8f);  // a side's normal
  CHECK(glm::distance(pushed(mesh, away + 0.3f * axis), away + axis) < 1e-3f);
  CHECK(pushed(mesh, away + 1.001f * axis) == away + 1.001f * axis);
  for (const float far : {1e3f, 1e9f, 1e30f})
    CHECK(pushed(mesh, {far, -far, far}) == glm::vec3(far, -far, far));
}

TEST_CASE("closed surfaces that overlap are one body, and a surface turned over is a cavity") {
  const auto box = [](float min, float max) { return box_mesh(glm::vec3(min), glm::vec3(max)); };
  const Shape both = solid(joined(box(0, 0.5f), box(0.3f, 0.8f)), d);
  CHECK(is_inside(both, {0.1f, 0.1f, 0.1f}));
  CHECK(is_inside(both, {0.4f, 0.4f, 0.4f}));
  CHECK(is_inside(both, {0.7f, 0.7f, 0.7f}));
  CHECK_FALSE(is_inside(both, {0.1f, 0.1f, 0.7f}));
  const Shape hollow = solid(joined(box(0, 1), box(0.3f, 0.7f), true), d);
  CHECK(is_inside(hollow, {0.1f, 0.5f, 0.5f}));
  CHECK_FALSE(is_inside(hollow, {0.5f, 0.5f, 0.5f}));
}

TEST_CASE("the winding number is right where rays pass through vertices and edges") {
  // From the lattice, rays along x go through the vertices and along the edges of all triangles.
  const TriangleTree tree(
      joined(ball_mesh(glm::vec3(0), 1, 3), box_mesh({-3, -1, -1}, {-2, 1, 1})));
  for (int k = -7; k <= 7; ++k)
    for (int j = -7; j <= 7; ++j)
      for (int i = -15; i <= 7; ++i) {
        const glm::vec3 p = 0.25f * glm::vec3(i, j, k);
        const glm::vec3 from_box = glm::abs(p + glm::vec3(2.5f, 0, 0)) - glm::vec3(0.5f, 1, 1);
        const float outside_box = std::max({from_box.x, from_box.y, from_box.z});
        if (std::abs(outside_box) < 1e-3f || std::abs(glm::length(p) - 0.98f) < 0.05f)
          continue;  // on a surface
        CHECK(tree.winding_number(p) == (outside_box < 0 || glm::length(p) < 1));
      }
}

TEST_CASE("the nearest point is that of all triangles, one by one") {
  const TriangleSurface torus = askew(torus_mesh(0.5f, 0.2f, 24));
  const TriangleTree tree(torus);
  for (const glm::vec3& p : random_points(200, -1, 1)) {
    const auto found = tree.nearest(p), guessed = tree.nearest(p, 17);
    float least = 1e9f;
    for (const glm::uvec3& t : torus.triangles) {
      const TriangleTree one(
          {{torus.vertices[t.x], torus.vertices[t.y], torus.vertices[t.z]}, {{0, 1, 2}}});
      least = std::min(least, one.nearest(p).distance);
    }
    CHECK(found.distance == Approx(least));
    CHECK(found.distance == guessed.distance);
    CHECK(glm::distance(found.point, p) == Approx(found.distance));
    CHECK(tree.nearest(p, 0, 0.05f).distance <= 1.06f * least);
  }
}

TEST_CASE("samples of meshes lie half a spacing below the surface, evenly", "[slow]") {
  const float inset = 0.5f * d;
  SECTION("a cube") {
    check_samples(box_mesh(glm::vec3(0), glm::vec3(1)),
                  places_on(box_mesh(glm::vec3(inset), glm::vec3(1 - inset)), 20000));
  }
  SECTION("a cube askew") {
    check_samples(askew(box_mesh(glm::vec3(0), glm::vec3(1))),
                  places_on(askew(box_mesh(glm::vec3(inset), glm::vec3(1 - inset))), 20000));
  }
  SECTION("a ball of large triangles, and of many in a spacing") {
    const int times = GENERATE(3, 6);
    check_samples(ball_mesh(glm::vec3(0), 0.4f, times),
                  places_on(ball_mesh(glm::vec3(0), 0.4f - inset, 5), 20000));
  }
  SECTION("a torus") {
    check_samples(askew(torus_mesh(0.5f, 0.2f)),
                  places_on(askew(torus_mesh(0.5f, 0.2f - inset)), 20000));
  }
}

TEST_CASE("no place on a concave body is far from a sample") {
  const TriangleSurface l = askew(l_mesh());
  const auto samples = positions(sample_surface(solid(l, d), d));
  // Half a spacing down and up to 0.9 aside make 1.03; a corner's sample is 0.87 away.
  CHECK(spread(samples, places_on(l, 15000)).hole < 1.3f * d);
  CHECK(static_cast<double>(samples.size()) == Approx(5.28 / (d * d)).epsilon(0.15));
}

TEST_CASE("a wall thinner than a spacing has one layer of samples, in its middle") {
  const float wall = GENERATE(0.005f, 0.02f, 0.3f, 0.9f, 1.2f) * d;
  const TriangleSurface plate = box_mesh({0, 0, 0}, {1, wall, 1});
  const auto samples = sample_surface(solid(plate, d), d);
  int inner = 0;
  for (const SurfaceSample& s : samples) {
    const glm::vec3 p = s.position;
    if (std::min({p.x, p.z, 1 - p.x, 1 - p.z}) < d)
      continue;  // the rim
    ++inner;
    CHECK(p.y == Approx(0.5f * wall).margin(0.01f * d));
    CHECK(s.side == SurfaceSample::Side::both);
  }
  CHECK(inner > std::lround(0.81f / (d * d)));
  CHECK(spread(positions(samples), places_on(plate, 6000)).hole < 1.3f * d);
}

TEST_CASE("a wall of one and a half spacings has two layers, each told its side") {
  const float wall = 1.5f * d;
  for (const SurfaceSample& s : sample_surface(solid(box_mesh({0, 0, 0}, {1, wall, 1}), d), d)) {
    const glm::vec3 p = s.position;
    if (std::min({p.x, p.z, 1 - p.x, 1 - p.z}) < d)
      continue;
    CHECK(s.side == SurfaceSample::Side::one);
    CHECK(p.y == Approx(s.normal.y > 0 ? d : 0.5f * d).margin(0.01f * d));
  }
}

TEST_CASE("a mesh gives the same samples and contacts for any number of threads") {
  const TriangleSurface surface = askew(torus_mesh(0.5f, 0.2f));
  const int before = omp_get_max_threads();
  std::vector<glm::vec3> first;
  for (const int threads : {1, 2, 4}) {
    omp_set_num_threads(threads);
    const Shape mesh = solid(surface, d);
    std::vector<glm::vec3> all = positions(sample_surface(mesh, d));
    for (const glm::vec3& p : random_points(2000, -0.7f, 0.7f))
      all.push_back(pushed(mesh, p));
    if (first.empty())
      first = all;
    CHECK(all == first);
  }
  omp_set_num_threads(before);
}

}  // namespace sim_mesh_tests
