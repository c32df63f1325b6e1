#include <catch2/catch.hpp>
#include <cstring>
#include <glm/glm.hpp>
#include <sstream>
#include <vector>

#include "output_support.hpp"
#include "render/output/output.hpp"

namespace output_ply_tests {

using namespace spindrift;
using namespace spindrift::output_test;
using Catch::Matchers::Contains;

namespace {

// A PLY file as its header says: lines without the comments, then bytes.
struct Ply {
  std::vector<std::string> lines;
  std::string comments;
  std::string data;
  std::size_t at = 0;

  explicit Ply(const std::filesystem::path& file) {
    const std::string all = content_of(file);
    const std::string mark = "end_header\n";
    const std::size_t end = all.find(mark);
    REQUIRE(end != std::string::npos);
    data = all.substr(end + mark.size());
    std::istringstream header(all.substr(0, end));
    for (std::string line; std::getline(header, line);)
      if (line.rfind("comment", 0) == 0)
        comments += line + "\n";
      else
        lines.push_back(line);
  }

  template <class T>
  T next() {
    T value{};
    REQUIRE(at + sizeof(T) <= data.size());
    std::memcpy(&value, data.data() + at, sizeof(T));
    at += sizeof(T);
    return value;
  }
};

using Lines = std::vector<std::string>;

}  // namespace

TEST_CASE("A mesh in PLY has its vertices, normals and faces exactly") {
  const TemporaryFolder folder;
  const Mesh mesh{{{0.1f, -2, 3}, {1e-20f, 5, 6e20f}, {7, 8, 9}, {-0.0f, 1, 2}},
                  {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6f, 0.8f, 0}},
                  {{0, 1, 2}, {2, 1, 3}}};
  output::write_ply(folder / "mesh.ply", mesh);
  Ply ply(folder / "mesh.ply");
  REQUIRE(ply.lines == Lines{"ply", "format binary_little_endian 1.0", "element vertex 4",
                             "property float x", "property float y", "property float z",
                             "property float nx", "property float ny", "property float nz",
                             "element face 2", "property list uchar int vertex_indices"});
  REQUIRE_THAT(ply.comments, Contains("x y z in m"));
  REQUIRE(ply.data.size() == 4 * 24 + 2 * 13);
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    REQUIRE(ply.next<glm::vec3>() == mesh.vertices[i]);
    REQUIRE(ply.next<glm::vec3>() == mesh.normals[i]);
  }
  for (const glm::uvec3& triangle : mesh.triangles) {
    REQUIRE(ply.next<std::uint8_t>() == 3);
    REQUIRE(ply.next<glm::uvec3>() == triangle);
  }
  REQUIRE(folder.entries() == 1);
}

TEST_CASE("A mesh without normals and an empty mesh are valid PLY") {
  const TemporaryFolder folder;
  output::write_ply(folder / "a.ply", Mesh{{{1, 2, 3}}, {}, {}});
  REQUIRE(Ply(folder / "a.ply").data.size() == 12);
  output::write_ply(folder / "a.ply", Mesh{});
  const Ply empty(folder / "a.ply");
  REQUIRE(empty.data.empty());
  REQUIRE(empty.lines[2] == "element vertex 0");
}

TEST_CASE("Particles in PLY have all their attributes exactly") {
  const TemporaryFolder folder;
  const std::vector<glm::vec3> positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}};
  const std::vector<glm::vec3> velocities = {{-1, 0, 0}, {0, -2, 0}, {0, 0, 0.3f}};
  const std::vector<float> densities = {998, 1000, 1002.5f};
  const std::vector<float> pressures = {0, 1e5f, -3};
  output::write_ply(folder / "p.ply",
                    std::vector<output::ParticleAttribute>{{"x y z", "m", positions},
                                                           {"vx vy vz", "m/s", velocities},
                                                           {"density", "kg/m^3", densities},
                                                           {"pressure", "Pa", pressures}});
  Ply ply(folder / "p.ply");
  REQUIRE(ply.lines == Lines{"ply", "format binary_little_endian 1.0", "element vertex 3",
                             "property float x", "property float y", "property float z",
                             "property float vx", "property float vy", "property float vz",
                             "property float density", "property float pressure"});
  REQUIRE_THAT(ply.comments, Contains("m/s") && Contains("kg/m^3") && Contains("pressure in Pa"));
  REQUIRE(ply.data.size() == 3 * 32);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    REQUIRE(ply.next<glm::vec3>() == positions[i]);
    REQUIRE(ply.next<glm::vec3>() == velocities[i]);
    REQUIRE(ply.next<float>() == densities[i]);
    REQUIRE(ply.next<float>() == pressures[i]);
  }
}

TEST_CASE("Whole numbers in PLY are unsigned integers, and have no unit where none is given") {
  const TemporaryFolder folder;
  const std::vector<glm::vec3> positions = {{1, 2, 3}, {4, 5, 6}};
  const std::vector<std::uint32_t> ids = {7, 4'000'000'000u};
  output::write_ply(folder / "p.ply", std::vector<output::ParticleAttribute>{
                                          {"x y z", "m", positions}, {"id", "", ids}});
  Ply ply(folder / "p.ply");
  REQUIRE(ply.lines.back() == "property uint id");
  REQUIRE(ply.comments.find("id") == std::string::npos);
  REQUIRE(ply.data.size() == 2 * 16);
  REQUIRE(ply.next<glm::vec3>() == positions[0]);
  REQUIRE(ply.next<std::uint32_t>() == 7);
  REQUIRE(ply.next<glm::vec3>() == positions[1]);
  REQUIRE(ply.next<std::uint32_t>() == 4'000'000'000u);
}

TEST_CASE("Attributes of unequal length, and too few normals, are rejected") {
  const TemporaryFolder folder;
  const std::vector<glm::vec3> two(2), three(3);
  const auto write = [&](const std::vector<output::ParticleAttribute>& attributes) {
    output::write_ply(folder / "p.ply", attributes);
  };
  REQUIRE_THROWS_AS(write({{"x y z", "m", two}, {"vx vy vz", "m/s", three}}),
                    std::invalid_argument);
  REQUIRE_THROWS_AS(write({{"x y z", "m", two}, {"density", "", std::vector<float>(1)}}),
                    std::invalid_argument);
  REQUIRE_THROWS_AS(write({{"x y z", "m", {}}, {"density", "", std::vector<float>(1)}}),
                    std::invalid_argument);
  REQUIRE_THROWS_AS(output::write_ply(folder / "m.ply", Mesh{two, three, {}}),
                    std::invalid_argument);
  REQUIRE_THROWS_AS(output::write_obj(folder / "m.obj", Mesh{two, three, {}}),
                    std::invalid_argument);
  REQUIRE(folder.entries() == 0);
}

TEST_CASE("A mesh in OBJ is read back with every float as it was") {
  const TemporaryFolder folder;
  const bool normals = GENERATE(true, false);
  Mesh mesh{{{0.1f, -2, 3}, {1e-20f, 5, 6e20f}, {7, 1.f / 3, 9}, {-0.0f, 1, 16777217}},
            {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6f, 0.8f, 0}},
            {{0, 1, 2}, {2, 1, 3}}};
  if (!normals)
    mesh.normals.clear();
  output::write_obj(folder / "mesh.obj", mesh);
  std::istringstream text(content_of(folder / "mesh.obj"));
  Mesh read;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string kind, a, b, c;
    words >> kind >> a >> b >> c;
    const auto vector = [&] { return glm::vec3(std::stof(a), std::stof(b), std::stof(c)); };
    const auto index = [&](const std::string& word) {
      const std::size_t slashes = word.find("//");
      CHECK((slashes != std::string::npos) == normals);
      if (normals)
        CHECK(word.substr(0, slashes) == word.substr(slashes + 2));
      return static_cast<unsigned>(std::stoul(word)) - 1;
    };
    if (kind == "v")
      read.vertices.push_back(vector());
    else if (kind == "vn")
      read.normals.push_back(vector());
    else if (kind == "f")
      read.triangles.push_back({index(a), index(b), index(c)});
    else
      CHECK(kind == "#");
  }
  CHECK(read.vertices == mesh.vertices);
  CHECK(read.normals == mesh.normals);
  CHECK(read.triangles == mesh.triangles);
  CHECK(folder.entries() == 1);
}

TEST_CASE("A PLY that cannot be written is an error with its name") {
  const TemporaryFolder folder;
  REQUIRE_THROWS_WITH(output::write_ply(folder / "none/m.ply", Mesh{}), Contains("none/m.ply"));
  const std::vector<glm::vec3> many(100000);
  REQUIRE(fails_when_full(5000, "p.ply", [&] {
    output::write_ply(folder / "p.ply",
                      std::vector<output::ParticleAttribute>{{"x y z", "m", many}});
  }));
  REQUIRE(fails_when_full(5000, "m.obj", [&] {
    output::write_obj(folder / "m.obj", Mesh{many, {}, {}});
  }));
  REQUIRE(folder.entries() == 0);
}

}  // namespace output_ply_tests
