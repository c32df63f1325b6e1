// The results of a sweep's runs, which are read from their folders, and the tables made of them.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/sweep/sweep_folder.hpp"

namespace spindrift::app {

/// A kind of figure that runs have: a column of the table.
struct SweepMetric {
  std::string name;   ///< name on the command line and in sweep.json
  std::string title;  ///< name for people
  std::string unit = {};
};

/// The metrics of a plan's runs, those of their probes included.
std::vector<SweepMetric> metrics_of(const SweepPlan& plan);

/// Checks that each target of a plan names one of its metrics.
/// @throws SceneError for a target that does not, with the nearest names
void check_targets(const SweepPlan& plan);

/// Figures of one column of probes.csv over time.
struct ProbeSummary {
  double last = 0, min = 0, max = 0, mean = 0;  ///< figures of the readings that are not empty
};

/// The results of one run.
struct SweepResult {
  std::string failure;  ///< why the run failed; empty: it is done, or was not begun
  bool complete = false;
  std::map<std::string, double> figures;  ///< figures that the run has, by the metric's name
  Json curves;                            ///< probes over time: {"time_s": [...], "front_m": [...]}
  std::optional<double> distance;         ///< distance from the targets; least is nearest
};

/// Reads the results of all runs of a plan.
/// @param failures why each run failed; an empty text for those that did not
std::vector<SweepResult> read_results(const SweepPlan& plan, const SweepFolder& folder,
                                      const std::vector<std::string>& failures);

/// The whole sweep as JSON, for programs. Only the figures whose names end in seconds depend on the
/// machine's speed.
Json results_json(const SweepPlan& plan, const SweepFolder& folder,
                  const std::vector<SweepResult>& results);

/// The figures as CSV: a header, and a line for each run.
std::string results_csv(const SweepPlan& plan, const std::vector<SweepResult>& results);

/// The indices of the runs: where the plan has targets, the nearest to them first and runs without
/// the figures last; else in the order of the plan.
std::vector<std::size_t> ranked(const SweepPlan& plan, const std::vector<SweepResult>& results);

/// The value that a run has for a key that varies, also where the run leaves it as the scene has
/// it.
Json value_of(const SweepRun& run, const std::string& key);

}  // namespace spindrift::app
