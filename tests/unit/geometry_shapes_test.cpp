// What every shape promises, held against what its inside alone says.
#include <catch2/catch.hpp>
#include <cmath>
#include <memory>
#include <random>
#include <set>
#include <vector>

#include "mesh_support.hpp"
#include "sim/geometry/solid.hpp"

namespace geometry_shapes_tests {

using namespace spindrift::geometry;
using namespace spindrift::test;

namespace {

constexpr float d = 0.05f;  // spacing, m

TriangleMesh mesh_shape(TriangleSurface surface) {
  TriangleMesh mesh;
  mesh.body = std::make_shared<MeshBody>(std::move(surface), d);
  return mesh;
}

/// Some of every kind, along the axes and askew.
std::vector<Shape> shapes() {
  return {Box{{-0.4f, 0.1f, 0.2f}, {0.5f, 0.7f, 0.6f}},
          Sphere{{0.2f, 0.3f, -0.1f}, 0.4f},
          Cylinder{{0, 0, 0}, {0, 0.8f, 0}, 0.3f},
          Cylinder{{0.1f, 0, -0.2f}, {0.5f, 0.6f, 0.4f}, 0.25f},
          Capsule{{0, 0, 0}, {0.6f, 0, 0}, 0.3f},
          Capsule{{0.1f, 0, -0.2f}, {0.4f, 0.5f, 0.3f}, 0.25f},
          Cone{{0, 0, 0}, {0, 0.8f, 0}, 0.5f},
          Cone{{0, 0, 0}, {0.7f, 0, 0}, 0.2f, 0.45f},
          Cone{{0.1f, 0, -0.2f}, {0.4f, 0.5f, 0.3f}, 0.5f, 0.15f},
          Cone{{0, 0, 0}, {0, 0.3f, 0}, 0.7f},
          mesh_shape(box_mesh({-0.3f, -0.2f, -0.4f}, {0.3f, 0.4f, 0.3f}))};
}

/// How far a mesh's contact may be off: its distances stand on a grid.
float tolerance_of(const Shape& shape) {
  return std::holds_alternative<TriangleMesh>(shape) ? 0.15f * d : 1e-5f;
}

class Places {
 public:
  explicit Places(const Box& bounds) : bounds_(bounds) {}

  glm::vec3 next() {
    std::uniform_real_distribution<float> part(-0.3f, 1.3f);
    const glm::vec3 t(part(random_), part(random_), part(random_));
    return bounds_.min + t * (bounds_.max - bounds_.min);
  }

 private:
  std::mt19937 random_{5};
  Box bounds_;
};

double area_of(const Tessellation& mesh) {
  return spindrift::geometry::area_of(TriangleSurface{mesh.vertices, mesh.triangles});
}

}  // namespace

TEST_CASE("there is a shape of every kind in these tests") {
  std::set<std::size_t> kinds;
  for (const Shape& shape : shapes())
    kinds.insert(shape.index());
  CHECK(kinds.size() == std::variant_size_v<Shape>);
}

TEST_CASE("a shape's volume, area and bounds are those of its inside") {
  for (const Shape& shape : shapes()) {
    CAPTURE(name_of(shape), shape.index());
    CHECK(problem_of(shape).empty());
    const Box bounds = bounds_of(shape);
    const Solid solid = solid_of(shape);
    constexpr int across = 80;
    const glm::vec3 step = (bounds.max - bounds.min) / float{across};
    int count = 0;
    for (int k = -2; k < across + 2; ++k)
      for (int j = -2; j < across + 2; ++j)
        for (int i = -2; i < across + 2; ++i) {
          const glm::vec3 at = glm::vec3(i, j, k) + 0.5f;
          const bool beyond = glm::any(glm::lessThan(at, glm::vec3(0))) ||
                              glm::any(glm::greaterThan(at, glm::vec3(across)));
          if (solid.contains(bounds.min + step * at)) {
            ++count;
            if (beyond)
              FAIL_CHECK("inside, and beyond the bounds");
          }
        }
    CHECK(count * double{step.x} * step.y * step.z == Approx(volume_of(shape)).epsilon(0.01));
    Tessellation mesh;
    tessellate(mesh, shape);
    CHECK(area_of(mesh) == Approx(spindrift::geometry::area_of(shape)).epsilon(0.01));
    glm::vec3 low(1e9f), high(-1e9f);
    for (const glm::vec3& v : mesh.vertices) {
      low = glm::min(low, v);
      high = glm::max(high, v);
    }
    CHECK(glm::distance(low, bounds.min) < 5e-3f);
    CHECK(glm::distance(high, bounds.max) < 5e-3f);
  }
}

TEST_CASE("a point inside a shape is taken to the nearest point of its surface") {
  for (const Shape& shape : shapes()) {
    CAPTURE(name_of(shape));
    const Solid solid = solid_of(shape);
    const float tolerance = tolerance_of(shape);
    Places places(bounds_of(shape));
    std::vector<glm::vec3> inside, on_surface;
    for (int k = 0; k < 2000; ++k) {
      const glm::vec3 p = places.next(), out = solid.push_out(p);
      if (!solid.contains(p)) {
        CHECK(out == p);
        continue;
      }
      inside.push_back(p);
      on_surface.push_back(out);
      const glm::vec3 way = out - p;
      if (glm::length(way) > 4 * tolerance) {
        CHECK_FALSE(solid.contains(out + 2 * tolerance * glm::normalize(way)));
        CHECK(solid.contains(out - 2 * tolerance * glm::normalize(way)));
      }
    }
    REQUIRE(inside.size() >= 100);
    float worst = 0;
    for (std::size_t i = 0; i < inside.size(); ++i)
      for (const glm::vec3& q : on_surface)
        worst =
            std::max(worst, glm::distance(inside[i], on_surface[i]) - glm::distance(inside[i], q));
    CHECK(worst < 2 * tolerance + 1e-5f);
  }
}

TEST_CASE("a point on the axis of a round shape is pushed straight off the axis") {
  const glm::vec3 from(0), to(3), axis = glm::normalize(to), middle(1.5f);
  for (const Shape& shape : {Shape{Cylinder{from, to, 0.2f}}, Shape{Capsule{from, to, 0.2f}},
                             Shape{Cone{from, to, 0.2f, 0.2f}}}) {
    CAPTURE(name_of(shape));
    const glm::vec3 way = solid_of(shape).push_out(middle) - middle;
    CHECK(glm::length(way) == Approx(0.2f).epsilon(1e-4));
    CHECK(std::abs(glm::dot(way, axis)) < 1e-5f);
  }
}

TEST_CASE("a way enters a shape where its inside begins, and is kept out of it") {
  for (const Shape& shape : shapes()) {
    CAPTURE(name_of(shape));
    const Solid solid = solid_of(shape);
    const float margin = 1e-3f * d, tolerance = tolerance_of(shape);
    Places places(bounds_of(shape));
    int moved_for_nothing = 0;  // such ways pass within the margin
    for (int k = 0; k < 400; ++k) {
      const glm::vec3 from = places.next(), to = places.next();
      if (solid.contains(from))
        continue;
      constexpr int steps = 1500;
      int first = 0;
      while (first <= steps && !solid.contains(glm::mix(from, to, float(first) / steps)))
        ++first;
      const Entry entry = solid.entry_between(from, to);
      const float step = glm::distance(from, to) / steps;
      if (first <= steps) {
        CHECK(solid.may_meet(from, to, 0));
        REQUIRE(entry.found);
        // Slanting ways are long within what the inside is off by.
        const float slant = std::abs(glm::dot(glm::normalize(to - from), entry.normal));
        const float off = glm::distance(from, to) * std::abs(entry.part - float(first) / steps);
        CHECK((off < 2 * step + 2 * tolerance || off * slant < 2 * step + 2 * tolerance));
        CHECK(glm::length(entry.normal) == Approx(1).epsilon(1e-4));
      } else if (entry.found) {  // it only just touches
        const glm::vec3 touched = glm::mix(from, to, entry.part);
        CHECK(solid.contains(touched - (step + 4 * tolerance) * entry.normal));
      }
      const glm::vec3 end = solid.end_outside(from, to, margin);
      moved_for_nothing += first > steps && !entry.found && glm::distance(end, to) > 2 * margin;
      if (entry.found && !solid.contains(end))
        CHECK_FALSE(solid.entry_between(end, end + 1e-6f * entry.normal).found);
    }
    CHECK(moved_for_nothing <= 1);
  }
}

TEST_CASE("samples of a shape lie half a spacing below its surface, one per spacing squared") {
  for (const Shape& shape : shapes()) {
    CAPTURE(name_of(shape), shape.index());
    const Solid solid = solid_of(shape);
    const auto samples = sample_surface(shape, d);
    float shallowest = 1, deepest = 0;
    for (const SurfaceSample& sample : samples) {
      const float depth = glm::distance(sample.position, solid.push_out(sample.position));
      shallowest = std::min(shallowest, depth);
      deepest = std::max(deepest, depth);
    }
    const float slack = 0.06f * d + tolerance_of(shape);
    CHECK(shallowest > 0.5f * d - slack);
    CHECK(deepest < 0.5f * d + slack);
    const double layer = spindrift::geometry::area_of(shape) / (d * d);
    CHECK(static_cast<double>(samples.size()) < 1.1 * layer);
    CHECK(static_cast<double>(samples.size()) > 0.65 * layer);  // the layer is smaller
  }
}

TEST_CASE("a shape's mirror image is one") {
  const Mirror mirror{{0.3f, 0, 1}, {-1, 1, -1}};
  for (const Shape& shape : shapes()) {
    const auto image = mirrored(shape, mirror);
    CHECK(image.has_value() == !std::holds_alternative<TriangleMesh>(shape));
    if (!image)
      continue;
    Places places(bounds_of(shape));
    for (int k = 0; k < 500; ++k) {
      const glm::vec3 p = places.next(), out = push_out(shape, p);
      if (out == p || glm::distance(out, p) > 1e-4f)
        CHECK(is_inside(*image, mirror(p)) == is_inside(shape, p));
    }
  }
}

}  // namespace geometry_shapes_tests
