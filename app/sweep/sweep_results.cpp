#include "app/sweep/sweep_results.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>

#include "app/errors/nearest_name.hpp"
#include "app/files/csv.hpp"
#include "app/run/report.hpp"
#include "render/output/input_file.hpp"

namespace spindrift::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_curve_points = 400;

/// A metric that every run has, and the key of its figure in run.json; empty where run.json has
/// none.
struct RunFigure {
  SweepMetric metric;
  std::string in_report;
};

const std::vector<RunFigure>& run_figures() {
  static const std::vector<RunFigure> figures{
      {{"simulation_seconds", "simulation", "s"}, ""},
      {{"drawing_seconds", "drawing", "s"}, "wall_seconds"},
      {{"particles", "particles"}, "particles"},
      {{"steps", "steps"}, "steps"},
      {{"rejected_steps", "refused steps"}, "rejected_steps"},
      {{"iterations", "iterations"}, "iterations"},
      {{"mean_compression", "mean compression"}, "worst_mean_compression"},
      {{"max_compression", "largest compression"}, "worst_max_compression"}};
  return figures;
}

/// The numbers in a column's cells; NaN where a cell is empty or no number.
std::vector<double> numbers_in(const std::vector<std::string>& cells) {
  std::vector<double> numbers;
  for (const std::string& cell : cells) {
    double& number = numbers.emplace_back(std::nan(""));
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), number);
    if (error != std::errc() || end != cell.data() + cell.size())
      number = std::nan("");
  }
  return numbers;
}

ProbeSummary summary_of(const std::vector<double>& values) {
  ProbeSummary s{.last = std::nan(""), .min = INFINITY, .max = -INFINITY, .mean = 0};
  std::size_t count = 0;
  for (const double value : values) {
    if (std::isnan(value))
      continue;
    s.last = value;
    s.min = std::min(s.min, value);
    s.max = std::max(s.max, value);
    s.mean += value;
    ++count;
  }
  s.mean /= static_cast<double>(count);
  return s;
}

/// A list of at most `most_curve_points` of the values, evenly spread, so that the page of a sweep
/// of many runs stays small.
Json thinned(const std::vector<double>& values) {
  Json list = Json::array();
  const std::size_t every = values.size() / most_curve_points + 1;
  for (std::size_t i = 0; i < values.size(); i += every)
    list.push_back(std::isnan(values[i]) ? Json() : Json(values[i]));
  return list;
}

/// Adds the figures and curves of a probes.csv, where there is one.
void read_probe_figures(const fs::path& file, SweepResult& result) {
  if (!fs::is_regular_file(file))
    return;
  for (const auto& [name, cells] : csv_columns(output::read_file(file))) {
    const std::vector<double> values = numbers_in(cells);
    result.curves[name] = thinned(values);
    const ProbeSummary s = summary_of(values);
    if (name == "time_s" || std::isnan(s.last))
      continue;
    result.figures[name] = s.last;
    result.figures[name + ".min"] = s.min;
    result.figures[name + ".max"] = s.max;
    result.figures[name + ".mean"] = s.mean;
  }
}

/// The number that an object has under a name; 0 where it has none.
double number_in(const Json& json, const std::string& name) {
  const Json value = json.is_object() ? json.value(name, Json()) : Json();
  return value.is_number() ? value.get<double>() : 0.;
}

void read_run(const SweepRun& run, const SweepFolder& folder, SweepResult& result) {
  result.complete = result.failure.empty() && folder.is_drawn(run);
  if (!result.complete)
    return;
  const Json report = json_in(folder.run(run) / "run.json");
  for (const RunFigure& figure : run_figures())
    if (!figure.in_report.empty())
      result.figures[figure.metric.name] = number_in(report, figure.in_report);
  double seconds = 0;
  if (std::ifstream(folder.simulation(run) / seconds_file) >> seconds)
    result.figures["simulation_seconds"] = seconds;
  if (!run.scene.probes.empty())
    read_probe_figures(folder.run(run) / "probes.csv", result);
}

/// The distance of a run from the targets: the root mean square of its differences from them, each
/// as a part of the target, or as it is where the target is 0. Nothing where the run lacks a
/// figure.
std::optional<double> distance_of(const SweepPlan& plan, const SweepResult& result) {
  double sum = 0;
  for (const SweepTarget& target : plan.targets) {
    const auto found = result.figures.find(target.key);
    if (found == result.figures.end())
      return std::nullopt;
    const double scale = target.value == 0 ? 1 : std::abs(target.value);
    sum += std::pow((found->second - target.value) / scale, 2);
  }
  return std::sqrt(sum / static_cast<double>(plan.targets.size()));
}

Json comparisons_json(const SweepPlan& plan, const SweepFolder& folder,
                      const std::vector<SweepResult>& results) {
  Json all = Json::array();
  for (const SweepPair& pair : pairs_of(plan)) {
    if (!results[pair.a].complete || !results[pair.b].complete || !folder.is_compared(plan, pair))
      continue;
    const fs::path place = folder.difference(plan.runs[pair.a], plan.runs[pair.b]);
    const Json found = json_in(place / differences_file);
    all.push_back({{"a", plan.runs[pair.a].name},
                   {"b", plan.runs[pair.b].name},
                   {"folder", fs::relative(place, folder.root()).string()},
                   {"all_frames", pair.all_frames},
                   {"flip", number_in(found, "flip")},
                   {"ssim", number_in(found, "ssim")},
                   {"changed", number_in(found, "changed")},
                   {"frames", found.value("frames", Json::array())},
                   {"pictures", comparison_of(plan, pair).at("pictures")}});
  }
  return all;
}

}  // namespace

std::vector<SweepMetric> metrics_of(const SweepPlan& plan) {
  std::vector<SweepMetric> metrics;
  for (const RunFigure& figure : run_figures())
    metrics.push_back(figure.metric);
  if (plan.reference)
    metrics.push_back({"flip", "FLIP to the reference"});
  for (const SweepRun& run : plan.runs)
    for (const sim::Probe& probe : run.scene.probes)
      for (const sim::ProbeColumn& column : sim::probe_columns(probe)) {
        const std::string name = fmt::format("{}_{}", column.name, column.unit);
        const auto has_name = [&](const SweepMetric& m) { return m.name == name; };
        if (std::any_of(metrics.begin(), metrics.end(), has_name))
          continue;
        metrics.push_back({name, std::string(column.name), std::string(column.unit)});
        for (const char* what : {"min", "max", "mean"})
          metrics.push_back({name + "." + what, fmt::format("{} {}", column.name, what),
                             std::string(column.unit)});
      }
  return metrics;
}

void check_targets(const SweepPlan& plan) {
  const std::vector<SweepMetric> metrics = metrics_of(plan);
  std::vector<std::string_view> names;
  for (const SweepMetric& metric : metrics)
    names.push_back(metric.name);
  for (const SweepTarget& target : plan.targets)
    if (std::find(names.begin(), names.end(), target.key) == names.end())
      throw SceneError(fmt::format("{}: there is no such figure{}; {}", target.place,
                                   target.key == "flip" ? " without a reference" : "",
                                   suggestion(target.key, names)));
}

std::vector<SweepResult> read_results(const SweepPlan& plan, const SweepFolder& folder,
                                      const std::vector<std::string>& failures) {
  std::vector<SweepResult> results(plan.runs.size());
  for (std::size_t i = 0; i < results.size(); ++i) {
    results[i].failure = failures[i];
    read_run(plan.runs[i], folder, results[i]);
  }
  for (const SweepPair& pair : pairs_of(plan)) {
    const std::size_t other = pair.a == plan.reference ? pair.b : pair.a;
    if (!pair.all_frames || !results[other].complete || !folder.is_compared(plan, pair))
      continue;
    const fs::path place = folder.difference(plan.runs[pair.a], plan.runs[pair.b]);
    results[other].figures["flip"] = number_in(json_in(place / differences_file), "flip");
  }
  if (plan.reference && results[*plan.reference].complete)
    results[*plan.reference].figures["flip"] = 0;
  if (!plan.targets.empty())
    for (SweepResult& result : results)
      result.distance = distance_of(plan, result);
  return results;
}

Json value_of(const SweepRun& run, const std::string& key) {
  for (const SweepValue& v : run.values)
    if (v.key == key)
      return v.value;
  std::string pointer = "/";
  for (const char c : key)
    if (c != ']')
      pointer += c == '.' || c == '[' ? '/' : c;
  const Json scene = to_json(run.scene);
  const Json::json_pointer at(pointer);
  return scene.contains(at) ? scene.at(at) : Json();
}

std::vector<std::size_t> ranked(const SweepPlan& plan, const std::vector<SweepResult>& results) {
  std::vector<std::size_t> order(plan.runs.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    order[i] = i;
  const auto distance = [&](std::size_t i) {
    return results[i].distance.value_or(std::numeric_limits<double>::infinity());
  };
  if (!plan.targets.empty())
    std::stable_sort(order.begin(), order.end(),
                     [&](auto a, auto b) { return distance(a) < distance(b); });
  return order;
}

Json results_json(const SweepPlan& plan, const SweepFolder& folder,
                  const std::vector<SweepResult>& results) {
  Json metrics = Json::array(), runs = Json::array(), targets = Json::object();
  const std::vector<SweepMetric> all = metrics_of(plan);
  for (const SweepMetric& m : all)
    metrics.push_back({{"name", m.name}, {"title", m.title}, {"unit", m.unit}});
  for (const SweepTarget& target : plan.targets)
    targets[target.key] = target.value;
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const SweepRun& run = plan.runs[i];
    Json values = Json::object(), figures = Json::object();
    for (const std::string& key : plan.keys)
      values[key] = value_of(run, key);
    for (const SweepMetric& m : all)
      if (const auto found = results[i].figures.find(m.name); found != results[i].figures.end())
        figures[m.name] = found->second;
    const VideoConfig& video = run.scene.video;
    runs.push_back({{"name", run.name},
                    {"values", values},
                    {"simulation", run.simulation},
                    {"complete", results[i].complete},
                    {"failure", results[i].failure},
                    {"width", video.width},
                    {"height", video.height},
                    {"frames_per_second", video.frames_per_second.per_second()},
                    {"frames", video.frame_count()},
                    {"figures", figures}});
    if (results[i].distance)
      runs.back()["distance"] = *results[i].distance;
  }
  const Json reference = plan.reference ? Json(plan.runs[*plan.reference].name) : Json();
  return {{"scene", plan.scene_file.filename().string()},
          {"versions", versions_json()},
          {"machine", machine_text()},
          {"keys", plan.keys},
          {"reference", reference},
          {"targets", targets},
          {"times", plan.times},
          {"metrics", metrics},
          {"runs", runs},
          {"comparisons", comparisons_json(plan, folder, results)}};
}

std::string results_csv(const SweepPlan& plan, const std::vector<SweepResult>& results) {
  const std::vector<SweepMetric> metrics = metrics_of(plan);
  std::vector<std::string> cells{"run"};
  cells.insert(cells.end(), plan.keys.begin(), plan.keys.end());
  for (const SweepMetric& m : metrics)
    cells.push_back(m.name);
  if (!plan.targets.empty())
    cells.emplace_back("distance");
  cells.emplace_back("failure");
  std::string text = csv_row(cells);
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const SweepResult& result = results[i];
    cells = {plan.runs[i].name};
    for (const std::string& key : plan.keys) {
      const Json value = value_of(plan.runs[i], key);
      cells.push_back(value.is_string() ? value.get<std::string>() : value.dump());
    }
    for (const SweepMetric& m : metrics) {
      const auto found = result.figures.find(m.name);
      cells.push_back(found == result.figures.end() ? "" : fmt::format("{:.9g}", found->second));
    }
    if (!plan.targets.empty())
      cells.push_back(result.distance ? fmt::format("{:.6g}", *result.distance) : "");
    cells.push_back(result.failure);
    text += csv_row(cells);
  }
  return text;
}

}  // namespace spindrift::app
