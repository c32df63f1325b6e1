#include "app/sweep/sweep_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "app/errors/nearest_name.hpp"
#include "app/scene/scene_fields.hpp"
#include "app/tables/values.hpp"

namespace spindrift::app {
namespace {

constexpr std::size_t most_runs = 10'000;
constexpr std::size_t most_letters = 40;  // in a value in a folder's name
constexpr std::size_t picture_count = 5;  // pictures set side by side where no times are given

std::string last_part(const std::string& key) {
  const auto dot = key.rfind('.');
  return dot == std::string::npos ? key : key.substr(dot + 1);
}

/// A value as a part of a folder's name. A value that is too long for it, or has other characters
/// than it may, is replaced by a hash.
std::string name_of(const Json& value) {
  std::string text;
  if (value.is_string())
    text = value.get<std::string>();
  else if (value.is_number())
    text = fmt::format("{}", value.get<double>());  // 1.0 is 1
  else if (value.is_array())
    for (const Json& entry : value)
      text += fmt::format("{}{}", text.empty() ? "" : "_", name_of(entry));
  else
    text = value.dump(-1, ' ', true, Json::error_handler_t::replace);
  const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_.+-";
  const bool readable = !text.empty() && text.find_first_not_of(plain) == std::string::npos &&
                        text.size() <= most_letters;
  return readable ? text : text_hash(value.dump()).substr(0, 8);
}

/// The names that stand for keys in folders' names: their last parts where those differ, else the
/// whole keys.
std::map<std::string, std::string> short_names(const std::vector<std::string>& keys) {
  std::map<std::string, int> uses;
  for (const std::string& key : keys)
    ++uses[last_part(key)];
  std::map<std::string, std::string> names;
  for (const std::string& key : keys)
    names[key] = uses[last_part(key)] == 1 ? last_part(key) : key;
  return names;
}

std::string run_name(const SweepValues& values, const std::map<std::string, std::string>& names) {
  std::string text;
  for (const SweepValue& v : values)
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", names.at(v.key), name_of(v.value));
  if (text.empty())
    return "unchanged";
  constexpr std::size_t most = 150;  // the name of a comparison's folder has two names
  return text.size() <= most ? text : text_hash(text).substr(0, 16);
}

/// A problem of a run's scene as a problem of the sweep: at the place where the value stands in the
/// sweep or, for a problem that no value of the sweep has, with the run's name.
/// @param all all values of the run, in the order of `overrides`
Problem in_the_sweep(const Problem& problem, const std::string& run, const SweepValues& all,
                     const std::vector<std::string>& overrides) {
  for (std::size_t i = 0; i < all.size(); ++i)
    if (problem.place.source == "--set " + overrides[i])
      return {{all[i].place}, problem.path, problem.message};
  return {problem.place, problem.path, fmt::format("{} (in the run {})", problem.message, run)};
}

/// Reads the scenes of runs, and gathers their problems.
class RunReader {
 public:
  explicit RunReader(const std::filesystem::path& file) : file_(file) {}

  /// Reads the scene of a run.
  /// @param all all values of the run
  /// @return nothing for a scene that can't be used
  std::optional<Scene> read(const std::string& name, const SweepValues& all) {
    Overrides overrides;
    for (const SweepValue& v : all)
      overrides.push_back(fmt::format("{}={}", v.key, v.value.dump()));
    try {
      return read_scene(file_, overrides);
    } catch (const SceneError& error) {
      for (const Problem& problem : error.problems())
        // A problem that several runs share is told once.
        if (told_.insert(problem.text()).second)
          problems_.push_back(in_the_sweep(problem, name, all, overrides));
      return std::nullopt;
    }
  }

  std::vector<Problem> problems() && { return std::move(problems_); }

 private:
  const std::filesystem::path& file_;
  std::set<std::string> told_;
  std::vector<Problem> problems_;
};

/// The name of the folder of a scene's simulation. Probes that are read between frames are read
/// while the liquid is simulated, so that runs with other such probes need a simulation of their
/// own.
std::string simulation_name(const Scene& scene) {
  std::string name = simulation_hash(scene);
  if (!scene.probes.empty() && scene.probes_rate > 0)
    name += fmt::format("-{:.8}", text_hash(json_of(scene.probes).dump()));
  return name;
}

std::vector<std::string> varying_keys(const std::vector<SweepAxis>& axes) {
  std::vector<std::string> keys;
  for (const SweepAxis& axis : axes)
    for (const SweepValues& row : axis)
      for (const SweepValue& v : row)
        if (axis.size() > 1 && std::find(keys.begin(), keys.end(), v.key) == keys.end())
          keys.push_back(v.key);
  return keys;
}

/// Refuses axes that make fewer than two runs or too many, or that vary a key twice: one would undo
/// the other. Of several values for all runs, the last one counts, as in the other commands.
/// @throws SceneError
void check_axes(const std::vector<SweepAxis>& axes) {
  std::map<std::string, std::pair<std::size_t, std::string>> first;
  std::size_t runs = 1;
  for (std::size_t a = 0; a < axes.size(); ++a) {
    for (const SweepValues& row : axes[a])
      for (const SweepValue& v : row) {
        const auto [at, is_new] = first.try_emplace(v.key, a, v.place);
        const std::size_t other = at->second.first;
        if (!is_new && other != a && (axes[a].size() > 1 || axes[other].size() > 1))
          throw SceneError(fmt::format("{}: {} is varied twice; the first time by {}", v.place,
                                       v.key, at->second.second));
      }
    runs *= std::max<std::size_t>(1, axes[a].size());
    if (runs > most_runs)
      throw SceneError(
          fmt::format("a sweep may have {} runs at most; these values make more", most_runs));
  }
  if (runs < 2)
    throw SceneError(
        "nothing varies: give a key two values or more, as in --set fluid.viscosity=0.01,0.1");
}

/// Calls f(all, varied) for each combination of the axes' alternatives, with all its values and
/// with those that vary. The alternatives of the last axis change fastest.
template <class F>
void for_each_combination(const std::vector<SweepAxis>& axes, F f) {
  std::vector<std::size_t> at(axes.size(), 0);
  for (;;) {
    SweepValues all, varied;
    for (std::size_t a = 0; a < axes.size(); ++a)
      for (const SweepValue& v : axes[a][at[a]]) {
        all.push_back(v);
        if (axes[a].size() > 1)
          varied.push_back(v);
      }
    f(all, varied);
    std::size_t a = axes.size();
    while (a > 0 && ++at[a - 1] == axes[a - 1].size())
      at[--a] = 0;
    if (a == 0)
      return;
  }
}

/// Whether a run has all wanted values, such as those of "viscosity=0.1,style=mesh".
/// @param wanted axes with one value each, whose keys may be given by their last parts
bool has_values(const SweepRun& run, const std::vector<SweepAxis>& wanted) {
  const auto has = [&](const SweepValue& w) {
    return std::any_of(run.values.begin(), run.values.end(), [&](const SweepValue& v) {
      return (v.key == w.key || last_part(v.key) == w.key) && v.value == w.value;
    });
  };
  return std::all_of(wanted.begin(), wanted.end(),
                     [&](const SweepAxis& axis) { return has(axis.front().front()); });
}

/// The assignments in a text such as "a=1,b=[2,3]"; none where a part of it is no assignment.
std::vector<SweepAxis> assignments_of(const std::string& text) {
  std::vector<SweepAxis> all;
  std::string key;
  for (const SweepValues& part : parse_sweep_axis(fmt::format("={}", text))) {
    const std::string word =
        part.front().value.is_string() ? part.front().value.get<std::string>() : "";
    if (word.find('=') == std::string::npos)
      return {};
    all.push_back(parse_sweep_axis(word));
  }
  return all;
}

/// The index of the run that a name, or values such as "viscosity=0.1", stand for.
/// @throws SceneError where no run, or more than one, is meant
std::size_t find_reference(const std::string& text, const std::vector<SweepRun>& runs) {
  std::vector<std::string_view> names;
  for (const SweepRun& run : runs)
    names.push_back(run.name);
  if (const auto at = std::find(names.begin(), names.end(), text); at != names.end())
    return static_cast<std::size_t>(at - names.begin());
  std::vector<std::size_t> found;
  if (const auto wanted = assignments_of(text); !wanted.empty())
    for (std::size_t i = 0; i < runs.size(); ++i)
      if (has_values(runs[i], wanted))
        found.push_back(i);
  if (found.size() == 1)
    return found.front();
  if (found.size() > 1)
    throw SceneError(fmt::format("reference {}: {} runs have these values; name one, such as {}",
                                 text, found.size(), names[found.front()]));
  throw SceneError(fmt::format(
      "reference {}: there is no such run; {}", text,
      suggestion(text, std::span(names).first(std::min<std::size_t>(names.size(), 20)))));
}

/// The times, s, of five pictures, spread evenly over the shortest video. They include its end but
/// not its start, where all runs are the same.
std::vector<double> picture_times(const SweepPlan& plan) {
  double last = plan.runs.front().scene.video.duration;
  for (const SweepRun& run : plan.runs) {
    const VideoConfig& video = run.scene.video;
    last = std::min(last, video.frames_per_second.time_of(video.frame_count() - 1));
  }
  std::vector<double> times;
  for (std::size_t k = 1; k <= picture_count; ++k)
    times.push_back(last * static_cast<double>(k) / picture_count);
  return times;
}

void check_times(const std::vector<double>& times, const std::vector<SweepRun>& runs) {
  double duration = 0;
  for (const SweepRun& run : runs)
    duration = std::max(duration, run.scene.video.duration);
  for (const double t : times)
    if (!(t >= 0 && t < duration))
      throw SceneError(
          fmt::format("times: {:g} is out of range; accepted: 0 ... {:g} s, before the videos' end",
                      t, duration));
}

}  // namespace

SweepAxis parse_sweep_axis(const std::string& assignment) {
  const std::string place = fmt::format("--set {}", assignment);
  const auto equals = assignment.find('=');
  if (equals == std::string::npos)
    throw SceneError(fmt::format(
        "{}: expected KEY=VALUE,VALUE,..., as in --set fluid.viscosity=0.01,0.1", place));
  const std::string key = trimmed(assignment.substr(0, equals));
  SweepAxis axis;
  std::string typed;
  int depth = 0;
  bool in_quotes = false;
  const auto add = [&] {
    axis.push_back({{key, typed_value(trimmed(typed), {place}), place}});
    typed.clear();
  };
  for (std::size_t i = equals + 1; i < assignment.size(); ++i) {
    const char c = assignment[i];
    in_quotes = in_quotes != (c == '"' && assignment[i - 1] != '\\');
    depth += in_quotes ? 0 : (c == '[' || c == '{') - (c == ']' || c == '}');
    if (c == ',' && depth == 0 && !in_quotes)
      add();
    else
      typed += c;
  }
  add();
  return axis;
}

SweepTarget parse_sweep_target(const std::string& text) {
  const auto equals = text.rfind('=');
  char* end = nullptr;
  const double value =
      equals == std::string::npos ? 0 : std::strtod(text.c_str() + equals + 1, &end);
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size() || *end != '\0' ||
      !std::isfinite(value))
    throw SceneError(
        fmt::format("--target {}: expected METRIC=NUMBER, as in --target steps=300", text));
  return {text.substr(0, equals), value, fmt::format("--target {}", text)};
}

SweepPlan plan_sweep(const SweepRequest& request) {
  check_axes(request.axes);
  SweepPlan plan{.scene_file = request.scene,
                 .keys = varying_keys(request.axes),
                 .runs = {},
                 .reference = {},
                 .targets = request.targets,
                 .times = request.times};
  const auto names = short_names(plan.keys);
  std::map<std::string, std::size_t> first;
  RunReader reader(request.scene);
  for_each_combination(request.axes, [&](const SweepValues& all, const SweepValues& varied) {
    const std::string name = run_name(varied, names);
    std::optional<Scene> scene = reader.read(name, all);
    if (!scene)
      return;
    SweepRun run{name, varied, std::move(*scene), {}};
    run.simulation = simulation_name(run.scene);
    if (!first.emplace(run.name, plan.runs.size()).second)
      throw SceneError(fmt::format("{}: two runs have the same values: {}",
                                   varied.empty() ? "list" : varied.back().place, run.name));
    plan.runs.push_back(std::move(run));
  });
  throw_if_any(std::move(reader).problems());
  if (!request.reference.empty())
    plan.reference = find_reference(request.reference, plan.runs);
  if (plan.times.empty())
    plan.times = picture_times(plan);
  check_times(plan.times, plan.runs);
  return plan;
}

}  // namespace spindrift::app
