#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "render/surface/cube_cases.hpp"
#include "render/surface/grid_key.hpp"
#include "render/surface/marching_cubes.hpp"
#include "render/surface/smoothing.hpp"
#include "surface_support.hpp"

namespace surface_internals_tests {

using namespace spindrift;
using namespace spindrift::surface;
using namespace spindrift::test;

namespace {

using Segment = std::pair<int, int>;  // from one cube edge to another

int upper_corner(int edge) {
  return cube_edge(edge).corner | (1 << cube_edge(edge).axis);
}

bool lies_on(int edge, int axis, int side) {
  return ((cube_edge(edge).corner >> axis) & 1) == side &&
         ((upper_corner(edge) >> axis) & 1) == side;
}

bool in_one_face(int edge_a, int edge_b) {
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      if (lies_on(edge_a, axis, side) && lies_on(edge_b, axis, side))
        return true;
  return false;
}

// Sides of a case's triangles that belong to one triangle only: the rim of its pieces.
std::set<Segment> rim(const CubeCase& cube) {
  std::map<Segment, int> sides;
  for (int i = 0; i < cube.triangle_count; ++i)
    for (int k = 0; k < 3; ++k)
      ++sides[{cube.triangles[i][k], cube.triangles[i][(k + 1) % 3]}];
  std::set<Segment> result;
  for (const auto& [side, count] : sides) {
    REQUIRE(count == 1);
    if (!sides.contains({side.second, side.first}))
      result.insert(side);
  }
  return result;
}

// The rim's lines on one face, each edge named by its place in the face so that the two cubes that
// share the face can be compared.
std::set<Segment> lines_on_face(int inside_corners, int axis, int side) {
  const auto place = [axis](int edge) {
    const int bit = 1 << axis;
    return (cube_edge(edge).corner & ~bit) * 8 + (upper_corner(edge) & ~bit);
  };
  std::set<Segment> lines;
  for (const auto& [from, to] : rim(cube_cases()[inside_corners]))
    if (lies_on(from, axis, side) && lies_on(to, axis, side))
      lines.insert({place(from), place(to)});
  return lines;
}

// The field of some particles with a spacing of 1 m.
SparseField field_of(const Points& points, float iso_value, double cell_size) {
  const ParticleBins bins(points, 1.0f, 2.5, 1 << 20);
  return SparseField(bins, measure_coverage(bins, iso_value), cell_size, iso_value);
}

}  // namespace

TEST_CASE("cube edges are numbered as drawn") {
  const int lower[12] = {0, 2, 4, 6, 0, 1, 4, 5, 0, 1, 2, 3};
  for (int e = 0; e < 12; ++e) {
    CHECK(cube_edge(e).axis == e / 4);
    CHECK(cube_edge(e).corner == lower[e]);
  }
}

TEST_CASE("every cube case makes closed loops through exactly the crossed edges") {
  for (int inside = 0; inside < 256; ++inside) {
    CAPTURE(inside);
    std::set<int> used, starts, ends;
    const CubeCase& cube = cube_cases()[inside];
    for (int i = 0; i < cube.triangle_count; ++i)
      used.insert(cube.triangles[i].begin(), cube.triangles[i].end());
    for (int e = 0; e < 12; ++e) {
      const bool crossed =
          ((inside >> cube_edge(e).corner) & 1) != ((inside >> upper_corner(e)) & 1);
      CHECK(used.contains(e) == crossed);
    }
    for (const auto& [from, to] : rim(cube)) {
      CHECK(starts.insert(from).second);
      CHECK(ends.insert(to).second);
      CHECK(in_one_face(from, to));
    }
    CHECK(starts == used);
    CHECK(ends == used);
  }
}

TEST_CASE("no cut within a cube lies in one of its faces") {
  for (int inside = 0; inside < 256; ++inside) {
    CAPTURE(inside);
    const CubeCase& cube = cube_cases()[inside];
    const std::set<Segment> lines = rim(cube);
    for (int i = 0; i < cube.triangle_count; ++i)
      for (int k = 0; k < 3; ++k) {
        const Segment side{cube.triangles[i][k], cube.triangles[i][(k + 1) % 3]};
        if (!lines.contains(side))
          CHECK_FALSE(in_one_face(side.first, side.second));
      }
  }
}

TEST_CASE("cubes that share a face agree about the surface on it") {
  for (int axis = 0; axis < 3; ++axis)
    for (int a = 0; a < 256; ++a)
      for (int b = 0; b < 256; ++b) {
        bool same_face = true;  // the upper face of a is the lower face of b
        for (int c = 0; c < 8; ++c)
          if (((c >> axis) & 1) == 0)
            same_face = same_face && ((a >> (c | 1 << axis)) & 1) == ((b >> c) & 1);
        if (!same_face)
          continue;
        std::set<Segment> reversed;
        for (const auto& [from, to] : lines_on_face(b, axis, 0))
          reversed.insert({to, from});
        if (lines_on_face(a, axis, 1) != reversed)
          FAIL("axis " << axis << ": case " << a << " below case " << b);
      }
}

TEST_CASE("one node inside makes an octahedron of 6 vertices and 8 triangles") {
  for (const glm::vec3 at : {glm::vec3(0.0f), glm::vec3(8.0f, -8.0f, 7.0f), glm::vec3(3.0f)}) {
    const IsoSurface surface = march_cubes(field_of({at}, 0.5f, 1.0), 0.5f, 1.0f);
    CHECK(surface.mesh.vertices.size() == 6);
    CHECK(surface.mesh.triangles.size() == 8);
    CHECK(topology_fault(surface.mesh) == "");
    CHECK(volume(surface.mesh) > 0.0);
    for (std::size_t v = 0; v < 6; ++v)
      CHECK(glm::distance(glm::normalize(surface.mesh.vertices[v] - at), surface.mesh.normals[v]) <
            1e-5f);
  }
}

TEST_CASE("the sparse field is the plain sum over all particles") {
  const Points points = random_cloud(120, 8.0f, 3);
  const ParticleBins bins(points, 1.0f, 2.5, 1 << 20);
  const Coverage coverage = measure_coverage(bins, 0.5f);
  const SparseField field(bins, coverage, 0.5, 0.5f);
  const auto shape = [](const glm::dvec3& r, double radius) {
    return std::pow(std::max(0.0, 1.0 - glm::dot(r, r) / (radius * radius)), 3.0);
  };
  const auto sum_around = [&](const glm::vec3& p, double radius) {
    double sum = 0.0;
    for (const glm::vec3& q : points)
      sum += shape(glm::dvec3(p - q), radius);
    return sum;
  };
  const double peak = 315.0 / (64.0 * 3.14159265358979 * 2.5 * 2.5 * 2.5);
  std::vector<double> radii, amplitudes;
  for (const glm::vec3& p : points) {
    const double t = std::clamp((peak * sum_around(p, 2.5) - 0.12) / 0.18, 0.0, 1.0);
    radii.push_back(1.5 + t);
    const double core = 0.5 / std::pow(1.0 - std::pow(0.62 / radii.back(), 2.0), 3.0);
    amplitudes.push_back(std::max(peak, core / sum_around(p, radii.back())));
  }
  for (int z = -14; z <= 14; z += 3)
    for (int y = -14; y <= 14; y += 3)
      for (int x = -14; x <= 14; x += 3) {
        double expected = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i)
          expected +=
              amplitudes[i] * shape(0.5 * glm::dvec3(x, y, z) - glm::dvec3(points[i]), radii[i]);
        const glm::ivec3 node(x, y, z);
        const glm::ivec3 in_block = node & 7;
        const float value =
            field.value(field.find(node >> 3), in_block.x + 8 * (in_block.y + 8 * in_block.z));
        CHECK(value == Approx(expected).margin(1e-5));
      }
}

TEST_CASE("blocks deep in the liquid are not sampled and change nothing") {
  const Points points = box_of_particles(glm::ivec3(24), 1.0f, 0.1f);
  const SparseField field = field_of(points, 0.5f, 0.5);
  const std::uint32_t middle = field.find({3, 3, 3});
  REQUIRE(middle != SparseField::no_block);
  CHECK(field.value(middle, 0) == 1.0f);
  CHECK(piece_count(march_cubes(field, 0.5f, 1.0f).mesh) == 1);
}

TEST_CASE("equal keys keep their order when sorted") {
  std::mt19937_64 random(5);
  std::vector<KeyedIndex> items;
  for (std::uint32_t i = 0; i < 5000; ++i)
    items.push_back({grid_key(glm::ivec3(int(random() % 7), int(random() % 3000), 5)), i});
  std::vector<KeyedIndex> expected = items;
  std::stable_sort(expected.begin(), expected.end(),
                   [](const KeyedIndex& a, const KeyedIndex& b) { return a.key < b.key; });
  sort_by_key(items);
  for (std::size_t i = 0; i < items.size(); ++i)
    REQUIRE((items[i].key == expected[i].key && items[i].index == expected[i].index));
}

TEST_CASE("a grid key gives its cell back") {
  for (const glm::ivec3 cell : {glm::ivec3(0), glm::ivec3(1, 2, 3), glm::ivec3((1 << 21) - 1)})
    CHECK(grid_cell(grid_key(cell)) == cell);
}

TEST_CASE("smoothing keeps thin features still and flattens noise over the bulk") {
  IsoSurface surface =
      march_cubes(field_of(sphere_of_particles(8.0f, 1.0f), 0.5f, 0.5), 0.5f, 1.0f);
  Mesh noisy = surface.mesh;
  std::mt19937 random(2);
  std::uniform_real_distribution<float> offset(-0.1f, 0.1f);
  for (glm::vec3& v : noisy.vertices)
    v += offset(random) * glm::normalize(v);
  const auto roughness = [](const Mesh& mesh) {
    double sum = 0.0;
    for (const glm::vec3& v : mesh.vertices)
      sum += std::pow(glm::length(v) - 8.0, 2.0);
    return std::sqrt(sum / double(mesh.vertices.size()));
  };
  Mesh smooth = noisy;
  smooth_mesh(smooth, std::vector<float>(noisy.vertices.size(), 1.0f), 10);
  CHECK(roughness(smooth) < 0.7 * roughness(noisy));
  CHECK(volume(smooth) == Approx(volume(noisy)).epsilon(0.005));

  Mesh still = noisy;
  smooth_mesh(still, std::vector<float>(noisy.vertices.size(), 0.5f), 10);
  CHECK(still.vertices == noisy.vertices);
}

}  // namespace surface_internals_tests
