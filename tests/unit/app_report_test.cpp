// What a run says of itself.
#include <catch2/catch.hpp>

#include "app/run/report.hpp"

namespace app_report_tests {

using namespace spindrift;
using namespace spindrift::app;

TEST_CASE("a run that is compressed beyond what was asked for says so") {
  Scene scene;
  RunRecord record;
  record.frames.resize(3);
  record.times = {0, 1, 2};
  record.frames[1].max_compression = 0.025;
  record.frames[1].mean_compression = 0.001;
  CHECK(report_json(scene, record, {})["warnings"].empty());
  record.frames[1].max_compression = 0.127;
  auto warnings = report_json(scene, record, {})["warnings"];
  REQUIRE(warnings.size() == 1);
  const std::string text = warnings[0];
  CHECK(text.find("12.7 %") != std::string::npos);
  CHECK(text.find("2.5 % of solver.max_compression") != std::string::npos);
  record.frames[2].mean_compression = 0.01;
  CHECK(report_json(scene, record, {})["warnings"].size() == 2);
  scene.simulation.solver.type = sim::SolverType::sph;
  CHECK(report_json(scene, record, {})["warnings"].empty());
  record.frames[2].mean_compression = 0.48;
  warnings = report_json(scene, record, {})["warnings"];
  REQUIRE(warnings.size() == 1);
  CHECK(std::string(warnings[0]).find("solver.speed_of_sound") != std::string::npos);
}

}  // namespace app_report_tests
