// OBJ and PLY as bytes: what is read, and where a damaged file is told to be wrong.
#include <fmt/format.h>
#include <sys/stat.h>

#include <algorithm>
#include <bit>
#include <catch2/catch.hpp>
#include <cstring>
#include <string>
#include <vector>

#include "app/mesh_files/mesh_file.hpp"
#include "app/mesh_files/mesh_readers.hpp"
#include "mesh_support.hpp"
#include "output_support.hpp"
#include "sim/geometry/mesh/closed_surface.hpp"
#include "sim/geometry/mesh/polygon.hpp"

namespace app_mesh_reader_tests {

using namespace spindrift;
using namespace spindrift::app;
using namespace spindrift::geometry;
using namespace spindrift::test;
using Catch::Matchers::Contains;
using output_test::TemporaryFolder;

namespace {

const std::string tetrahedron_obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

/// A header of vertices with a colour and of faces with a list of weights, and one more element.
std::string header(const std::string& format, std::uint64_t vertices, std::uint64_t faces) {
  return fmt::format(
      "ply\r\nformat {} 1.0\ncomment of no one\nelement note 1\nproperty list uchar char text\n"
      "element vertex {}\nproperty uchar red\nproperty double z\nproperty float x\n"
      "property short y\nelement face {}\nproperty list ushort float weights\n"
      "property list uchar int vertex_index\nend_header\n",
      format, vertices, faces);
}

template <class Number>
void put(std::string& bytes, Number number, bool big) {
  char of[sizeof number];
  std::memcpy(of, &number, sizeof number);
  if (big)
    std::reverse(of, of + sizeof number);
  bytes.append(of, sizeof number);
}

const std::vector<std::vector<int>> tetrahedron{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};

/// A tetrahedron with corners at 0, 1 and 2 on the axes: volume 8/6.
std::string binary_ply(bool big, const std::vector<std::vector<int>>& faces = tetrahedron) {
  std::string bytes = header(big ? "binary_big_endian" : "binary_little_endian", 4, faces.size());
  bytes += std::string("\2ab", 3);
  for (int k = 0; k < 4; ++k) {
    put<std::uint8_t>(bytes, 255, big);
    put<double>(bytes, k == 3 ? 2 : 0, big);
    put<float>(bytes, k == 1 ? 2 : 0, big);
    put<std::int16_t>(bytes, k == 2 ? 2 : 0, big);
  }
  for (const auto& face : faces) {
    put<std::uint16_t>(bytes, 1, big);
    put<float>(bytes, 0.5f, big);
    put(bytes, static_cast<std::uint8_t>(face.size()), big);
    for (const int corner : face)
      put<std::int32_t>(bytes, corner, big);
  }
  return bytes;
}

std::string text_ply(const std::string& last_face) {
  return header("ascii", 4, 4) + "2 97 98\n255 0 0 0\n255 0 2 0\n255 0 0 2\n255 2 0 0\n" +
         "1 .5 3 0 2 1\n0 3 0 1 3\n0 3 1 2 3\n" + last_face;
}

double volume_of(const sim::TriangleSurface& surface) {
  return enclosed_volume(closed_surface(surface));
}

}  // namespace

TEST_CASE("a PLY is read in every encoding, with elements and properties that no one asked for") {
  CHECK(volume_of(read_ply(binary_ply(false))) == Approx(8. / 6));
  CHECK(volume_of(read_ply(binary_ply(true))) == Approx(8. / 6));
  CHECK(volume_of(read_ply(text_ply("0 3 2 0 3"))) == Approx(8. / 6));
}

TEST_CASE("a damaged PLY is refused with the place and what is wrong there") {
  const std::string whole = binary_ply(false);
  for (std::size_t size = 0; size < whole.size(); ++size)
    CHECK_THROWS_WITH(read_ply(whole.substr(0, size)),
                      Contains("cut short") || Contains("is not a PLY"));
  CHECK_THROWS_WITH(read_ply(whole.substr(0, whole.size() - 2)),
                    Contains(fmt::format("byte {}: is cut short", whole.size() - 12)));

  const auto last = [](int corner) { return binary_ply(false, {{0, 1, 2}, {0, 1, corner}}); };
  CHECK_THROWS_WITH(read_ply(last(4)), Contains("face 1 has the vertex 4; accepted: 0 ... 3"));
  CHECK_THROWS_WITH(read_ply(last(2'000'000'000)), Contains("has the vertex 2000000000"));
  CHECK_THROWS_WITH(read_ply(last(-1)), Contains("has the vertex -1"));

  CHECK_THROWS_WITH(read_ply(text_ply("0 3 2 0 4")), Contains("line 23: face 3 has the vertex 4"));
  CHECK_THROWS_WITH(read_ply(text_ply("0 3 2 0")), Contains("line 23: is cut short"));
  CHECK_THROWS_WITH(read_ply(text_ply("0 300 2 0 4")), Contains("300 is not of the type uchar"));
  CHECK_THROWS_WITH(read_ply(text_ply("0 3 2 0 x\x1b[2J")),
                    Contains("\"x\\u001b[2J\" is not a number"));
  CHECK_THROWS_WITH(read_ply(text_ply("0 3 2 .5 1")), Contains(".5 is not of the type int"));
}

TEST_CASE("a PLY that claims more than it holds is refused before memory is taken") {
  for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
    const std::string note = format[0] == 'a' ? "0\n" : std::string(1, '\0');
    CHECK_THROWS_WITH(read_ply(header(format, 4'000'000'000, 1) + note + "1 2 3 4 5 6 7 8"),
                      Contains("cut short") && Contains("4000000000 elements \"vertex\""));
    CHECK_THROWS_WITH(read_ply(header(format, 0, 18'000'000'000'000'000'000u) + note + "1 2 3"),
                      Contains("cut short") && Contains("elements \"face\""));
  }
  const std::string list =
      "ply\nformat binary_little_endian 1.0\nelement vertex 0\nproperty float x\nproperty float y\n"
      "property float z\nelement face 1\nproperty list uint int vertex_indices\nend_header\n";
  CHECK_THROWS_WITH(read_ply(list + "\xff\xff\xff\xff"), Contains("a list of 4294967295 entries"));
}

TEST_CASE("a PLY's header is read strictly") {
  const auto with = [](const std::string& lines) {
    return "ply\nformat ascii 1.0\n" + lines + "end_header\n";
  };
  const std::string vertices =
      "element vertex 0\nproperty float x\nproperty float y\nproperty float z\n";
  CHECK_THROWS_WITH(read_ply("obj\n"), Contains("is not a PLY"));
  CHECK_THROWS_WITH(read_ply("ply\nend_header\n"), Contains("line 2: there is no line \"format\""));
  CHECK_THROWS_WITH(read_ply("ply\nformat ascii 2.0\n"), Contains("unknown format \"ascii 2.0\""));
  CHECK_THROWS_WITH(read_ply(with("element vertex -1\n")), Contains("line 3: \"-1\""));
  CHECK_THROWS_WITH(read_ply(with("property float x\n")), Contains("before the first element"));
  CHECK_THROWS_WITH(read_ply(with("element vertex 1\nproperty real x\n")),
                    Contains("line 4: unknown type \"real\""));
  CHECK_THROWS_WITH(read_ply(with("element face 1\nproperty list float int vertex_indices\n")),
                    Contains("whole numbers"));
  CHECK_THROWS_WITH(read_ply(with("element vertex 0\nproperty float x\n")),
                    Contains("need properties x, y and z"));
  CHECK_THROWS_WITH(read_ply(with(vertices + "element face 0\nproperty float a\n")),
                    Contains("need a list \"vertex_indices\""));
  CHECK_THROWS_WITH(read_ply(with("element rest 4000000000\n")), Contains("without a property"));
  CHECK_THROWS_WITH(read_ply(with("words\n")), Contains("line 3: \"words\" is not a line"));
  CHECK(read_ply(with(vertices)).triangles.empty());
}

TEST_CASE("an OBJ counts vertices from its beginning and, with a minus, from where it is") {
  const std::string faces = "f 1/1 3//2 2\r\nf -4 -3 -1\nf \\\n 2 3/5/6 4 # comment\nf +3 1 4\n";
  CHECK(volume_of(read_obj(tetrahedron_obj + faces)) == Approx(1. / 6));
  CHECK(volume_of(read_obj("f 1 3 2\nf 1 2 4\n" + tetrahedron_obj + "f 2 3 4\nf 3 1 4")) ==
        Approx(1. / 6));
}

TEST_CASE("a damaged OBJ is refused with the line and what is wrong there") {
  const auto complaint_of = [](const std::string& line) { return tetrahedron_obj + line; };
  CHECK_THROWS_WITH(read_obj(complaint_of("f 1 2 5")),
                    Contains("line 5: there is no vertex 5; accepted: 1 ... 4 and -4 ... -1"));
  CHECK_THROWS_WITH(read_obj(complaint_of("f 0 1 2")), Contains("there is no vertex 0"));
  CHECK_THROWS_WITH(read_obj(complaint_of("\n\nf -5 1 2")), Contains("line 7: there is no vertex"));
  CHECK_THROWS_WITH(read_obj("v 0 0 0\nf -2 1 1\n" + tetrahedron_obj), Contains("-1 ... -1"));
  CHECK_THROWS_WITH(read_obj(complaint_of("f 1 2 99999999999999999999")), Contains("line 5: \"9"));
  CHECK_THROWS_WITH(read_obj(complaint_of("f 1 2 1e3")), Contains("\"1e3\" is not a vertex's"));
  CHECK_THROWS_WITH(read_obj(complaint_of("f 1 2 \\\n 7")),
                    Contains("line 5: there is no vertex 7"));
  CHECK_THROWS_WITH(read_obj(complaint_of("v 1 2")), Contains("line 5: a vertex (v) needs three"));
  CHECK_THROWS_WITH(read_obj(complaint_of("v 1 2 three")), Contains("\"three\" is not a number"));
  for (const char* number : {"nan", "inf", "-inf", "1e39"})
    CHECK_THROWS_WITH(read_obj(complaint_of(fmt::format("v 0 {} 0", number))),
                      Contains("line 5: ") && Contains("is not a coordinate"));
}

TEST_CASE("files that are none are refused at once, and those that a mesh names are not opened") {
  const TemporaryFolder folder;
  REQUIRE(::mkfifo((folder / "pipe.obj").c_str(), 0600) == 0);
  CHECK_THROWS_WITH(read_mesh_file(folder / "pipe.obj"), Contains("is a pipe"));
  std::ofstream(folder / "mesh.obj") << "mtllib " << (folder / "pipe.obj").string() << "\n"
                                     << tetrahedron_obj << "usemtl a\nf 1 2 3\n";
  CHECK(read_mesh_file(folder / "mesh.obj").triangles.size() == 1);
}

TEST_CASE("polygons that are not convex are cut without leaving themselves") {
  // An L, and a square with a square hole that a seam leads to.
  struct Case {
    std::vector<glm::vec2> corners;
    double area;
  };
  const std::vector<Case> cases{
      {{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 3},
      {{{0, 0}, {3, 0}, {3, 3}, {0, 3}, {0, 0}, {1, 1}, {1, 2}, {2, 2}, {2, 1}, {1, 1}}, 8},
      {{{0, 0}, {1, 0}, {2, 0}, {2, 2}, {0, 2}}, 4}};
  for (const Case& polygon : cases) {
    for (const int axis : {0, 1, 2}) {
      for (const bool turned : {false, true}) {
        std::vector<glm::vec3> vertices;
        std::vector<std::uint32_t> corners;
        for (const glm::vec2& p : polygon.corners) {
          corners.push_back(static_cast<std::uint32_t>(vertices.size()));
          glm::vec3& v = vertices.emplace_back(0.5f * p.x);  // tilted
          v[(axis + 1) % 3] = p.x;
          v[(axis + 2) % 3] = p.y;
        }
        if (turned)
          std::reverse(corners.begin(), corners.end());
        std::vector<glm::uvec3> triangles;
        cut_polygon(vertices, corners, triangles);
        CHECK(triangles.size() == corners.size() - 2);
        double area = 0;
        for (const glm::uvec3& t : triangles) {
          const glm::vec3 normal =
              glm::cross(vertices[t.y] - vertices[t.x], vertices[t.z] - vertices[t.x]);
          area += 0.5 * normal[axis];
          CHECK((turned ? normal[axis] <= 0 : normal[axis] >= 0));
        }
        CHECK(area == Approx(turned ? -polygon.area : polygon.area));
      }
    }
  }
}

TEST_CASE("polygons of many corners are cut in time, or refused") {
  std::vector<glm::vec3> vertices;
  std::vector<std::uint32_t> corners;
  for (unsigned k = 0; k < 200'000; ++k) {
    const double angle = 2 * std::numbers::pi * k / 200'000;
    vertices.push_back({std::cos(angle), std::sin(angle), 0});
    corners.push_back(k);
  }
  std::vector<glm::uvec3> triangles;
  CHECK_THROWS_WITH(cut_polygon(vertices, corners, triangles), Contains("up to 1000"));
  vertices.resize(1000);
  corners.resize(1000);
  for (unsigned k = 0; k < 1000; ++k)  // a comb
    vertices[k] = {k == 0 ? 0 : k == 999 ? 998 : k, k == 0 || k == 999 ? 0 : k % 2 ? 1 : 9, 0};
  cut_polygon(vertices, corners, triangles);
  CHECK(triangles.size() == 998);
}

}  // namespace app_mesh_reader_tests
