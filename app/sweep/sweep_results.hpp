// What the runs of a sweep gave, read from their folders.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/sweep/sweep_folder.hpp"

namespace spindrift::app {

/// A figure of a run: a column of the table.
struct SweepMetric {
  std::string name;   ///< on the command line and in sweep.json
  std::string title;  ///< for people
  std::string unit = {};
};

/// The figures that a plan's runs can have, those of their probes included.
std::vector<SweepMetric> metrics_of(const SweepPlan& plan);

/// @throws SceneError for a target that no run can have
void check_targets(const SweepPlan& plan);

/// One column of probes.csv over time.
struct ProbeSummary {
  double last = 0, min = 0, max = 0, mean = 0;  ///< of the readings that were taken
};

struct SweepResult {
  std::string failure;  ///< empty: the run is done, or was not begun
  bool complete = false;
  std::map<std::string, double> figures;  ///< by the metric's name; those that the run has
  Json curves;                            ///< probes over time: {"time_s": [...], "front_m": [...]}
  std::optional<double> distance;         ///< from the targets; least is nearest
};

/// @param failures one for each run; empty: none
std::vector<SweepResult> read_results(const SweepPlan& plan, const SweepFolder& folder,
                                      const std::vector<std::string>& failures);

/// All of it for machines. What depends on the machine's speed are the figures called seconds.
Json results_json(const SweepPlan& plan, const SweepFolder& folder,
                  const std::vector<SweepResult>& results);

/// A line for each run.
std::string results_csv(const SweepPlan& plan, const std::vector<SweepResult>& results);

/// Run numbers: those nearest to the targets first, where there are any, failed ones last.
std::vector<std::size_t> ranked(const SweepPlan& plan, const std::vector<SweepResult>& results);

/// What a run has for a key that varies, also where the run leaves it as the scene has it.
Json value_of(const SweepRun& run, const std::string& key);

}  // namespace spindrift::app
