// The tables of scene files leave no setting out.
#include <catch2/catch.hpp>
#include <tuple>
#include <utility>

#include "app/scene/scene_fields.hpp"

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
}

}  // namespace app_tables_tests
