// The tables of scene and sweep files leave no setting out. Values of any kind, and objects whose
// keys a file chooses, are read and described by tables as well.
#include <catch2/catch.hpp>
#include <tuple>
#include <utility>

#include "app/scene/scene_fields.hpp"
#include "app/sweep/sweep_file.hpp"
#include "app/tables/schema.hpp"
#include "app/tables/table_reader.hpp"

namespace app_tables_tests {

/// A section with a value of each of the kinds that scenes do not have.
struct Shelf {
  std::vector<spindrift::app::Keyed<spindrift::app::Placed<int>>> books = {};
  spindrift::app::NonEmpty<double> heights = {};
  spindrift::app::Json label = {};
  double width = 0;

  void check(const spindrift::app::Complain& complain) const {
    if (width == 13)
      complain("width", "brings bad luck");
    if (width == -1)
      complain("depth", "is missing");
  }
};

}  // namespace app_tables_tests

template <>
inline constexpr auto spindrift::app::table<app_tables_tests::Shelf> = std::tuple{
    Field{"books", &app_tables_tests::Shelf::books, "pages by title", Range{1, 9999}},
    Field{"heights", &app_tables_tests::Shelf::heights, "of the boards", Range{0, 3}, "m"},
    Field{"label", &app_tables_tests::Shelf::label, "what is on it"},
    Field{"width", &app_tables_tests::Shelf::width, "how wide", any_number}};

namespace app_tables_tests {

using namespace spindrift;
using namespace spindrift::app;

namespace {

/// Stands for a member of any type in a list of initial values; never run.
struct Anything {
  template <class T>
  operator T() const;
};

template <class T, class Numbers>
inline constexpr bool takes = false;
template <class T, std::size_t... I>
inline constexpr bool takes<T, std::index_sequence<I...>> = requires {
  T{(static_cast<void>(I), Anything{})...};
};

/// How many members an aggregate has: the most initial values that it takes.
template <class T, std::size_t Count = 40>
constexpr std::size_t member_count() {
  if constexpr (Count == 0 || takes<T, std::make_index_sequence<Count>>)
    return Count;
  else
    return member_count<T, Count - 1>();
}

template <class T>
constexpr bool complete = member_count<T>() == std::tuple_size_v<decltype(table<T>)>;

}  // namespace

TEST_CASE("every member of every settings struct has its key") {
  STATIC_REQUIRE(member_count<sim::Cylinder>() == 3);
  STATIC_REQUIRE(complete<Scene>);
  STATIC_REQUIRE(complete<sim::Settings>);
  STATIC_REQUIRE(complete<sim::FluidSettings>);
  STATIC_REQUIRE(complete<sim::Volume>);
  STATIC_REQUIRE(complete<sim::Box>);
  STATIC_REQUIRE(complete<sim::Sphere>);
  STATIC_REQUIRE(complete<sim::Cylinder>);
  STATIC_REQUIRE(complete<sim::Capsule>);
  STATIC_REQUIRE(complete<sim::Cone>);
  // All but the body, which is made from the file.
  STATIC_REQUIRE(member_count<sim::TriangleMesh>() ==
                 1 + std::tuple_size_v<decltype(table<sim::TriangleMesh>)>);
  STATIC_REQUIRE(complete<sim::Probe>);
  STATIC_REQUIRE(complete<sim::SurfaceHeightProbe>);
  STATIC_REQUIRE(complete<sim::PressureProbe>);
  STATIC_REQUIRE(complete<sim::FrontProbe>);
  STATIC_REQUIRE(complete<sim::EnergyProbe>);
  STATIC_REQUIRE(complete<sim::VolumeProbe>);
  STATIC_REQUIRE(complete<sim::DomainSettings>);
  STATIC_REQUIRE(complete<sim::Obstacle>);
  STATIC_REQUIRE(complete<sim::Motion>);
  STATIC_REQUIRE(complete<sim::MotionKey>);
  STATIC_REQUIRE(complete<sim::Oscillation>);
  STATIC_REQUIRE(complete<sim::Spin>);
  STATIC_REQUIRE(complete<sim::Sink>);
  STATIC_REQUIRE(complete<sim::AirSettings>);
  STATIC_REQUIRE(complete<sim::Emitter>);
  STATIC_REQUIRE(complete<sim::Disc>);
  STATIC_REQUIRE(complete<sim::Rectangle>);
  STATIC_REQUIRE(complete<sim::ForceSettings>);
  STATIC_REQUIRE(complete<sim::AccelerationKey>);
  STATIC_REQUIRE(complete<sim::SolverSettings>);
  STATIC_REQUIRE(complete<surface::SurfaceSettings>);
  STATIC_REQUIRE(complete<CameraSettings>);
  STATIC_REQUIRE(complete<CameraKey>);
  STATIC_REQUIRE(complete<gl::LightSettings>);
  STATIC_REQUIRE(complete<gl::LookSettings>);
  STATIC_REQUIRE(complete<VideoConfig>);
  STATIC_REQUIRE(complete<SweepFile>);
  STATIC_REQUIRE(complete<LatinHypercube>);
  STATIC_REQUIRE(complete<SampledRange>);
}

TEST_CASE("objects with keys of a file's own choice are read in their order, with places") {
  Shelf shelf;
  read_document(SceneDocument(R"({"books": {"z.a": 3,
    "b": 4}, "heights": [1, 2], "label": {"a": [null]}, "width": -1e300})",
                              "shelf.json"),
                shelf);
  REQUIRE(shelf.books.size() == 2);
  CHECK(shelf.books[0].key == "z.a");
  CHECK(shelf.books[0].value.value == 3);
  CHECK(shelf.books[1].key == "b");
  CHECK(shelf.books[1].place == "shelf.json:2:5: books.b");
  CHECK(shelf.books[1].value.place == shelf.books[1].place);
  CHECK(shelf.heights == std::vector<double>{1, 2});
  CHECK(shelf.label.dump() == R"({"a":[null]})");
  CHECK(shelf.width == -1e300);
}

TEST_CASE("problems of such values are told at their places, and of those that do not fit too") {
  const auto complaint = [](const char* text) -> std::string {
    try {
      Shelf shelf;
      read_document(SceneDocument(text, "shelf.json"), shelf);
    } catch (const SceneError& error) {
      return error.what();
    }
    return "";
  };
  CHECK(complaint(R"({"books": {"a": 0, "b": 1.5}, "heights": [], "width": "w"})") ==
        "shelf.json:1:12: books.a: 0 is out of range; accepted: 1 ... 9999\n"
        "shelf.json:1:20: books.b: 1.5 is not a whole number; accepted: 1 ... 9999\n"
        "shelf.json:1:31: heights: expected a list [...] of at least one entry, found the list []\n"
        "shelf.json:1:46: width: expected a number (any), found \"w\"");
  CHECK(complaint(R"({"books": [1], "width": 13})") ==
        "shelf.json:1:2: books: expected an object {...}, found the list [1]\n"
        "shelf.json:1:16: width: brings bad luck");
  CHECK(complaint(R"({"width": -1})") == "shelf.json:1:1: is missing");
}

TEST_CASE("the schema says what such values may be") {
  const Json expected = Json::parse(R"json({
    "type": "object",
    "properties": {
      "books": {"description": "pages by title", "type": "object",
                "additionalProperties": {"type": "integer", "minimum": 1, "maximum": 9999}},
      "heights": {"description": "of the boards (m)", "type": "array", "minItems": 1,
                  "items": {"type": "number", "minimum": 0.0, "maximum": 3.0}},
      "label": {"description": "what is on it"},
      "width": {"description": "how wide", "type": "number", "default": 0.0}
    },
    "additionalProperties": false
  })json");
  CHECK(SchemaWriter::schema_for<Shelf>() == expected);
}

}  // namespace app_tables_tests
