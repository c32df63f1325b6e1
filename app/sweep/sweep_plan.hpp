// Which runs a sweep has: every combination of the values it was given.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/scene.hpp"
#include "app/tables/document.hpp"
#include "app/tables/table.hpp"

namespace spindrift::app {

/// A scene's key, such as fluid.viscosity, and what it is to be.
using SweepValue = Keyed<Json>;
using SweepValues = std::vector<SweepValue>;

/// Alternatives, of which each run takes one: the values of one key, or rows of several keys.
using SweepAxis = std::vector<SweepValues>;

/// A figure of a run, by the name of its metric, and the value that it is to come close to.
using SweepTarget = Keyed<double>;

/// What is asked for on the command line or in a sweep file.
struct SweepRequest {
  std::filesystem::path scene = {};
  std::vector<SweepAxis> axes = {};  ///< one with a single alternative holds for all runs
  std::string reference = {};  ///< a run's name, or values that one run alone has; empty: none
  std::vector<SweepTarget> targets = {};
  std::vector<double> times = {};  ///< of the pictures that are set side by side, s; empty: five
};

struct SweepRun {
  std::string name;        ///< of its folder: its values
  SweepValues values;      ///< of the keys that vary
  Scene scene;             ///< resolved
  std::string simulation;  ///< name of the simulation's folder; runs with the same name share it
};

struct SweepPlan {
  std::filesystem::path scene_file;
  std::vector<std::string> keys;  ///< that vary
  std::vector<SweepRun> runs;
  std::optional<std::size_t> reference;  ///< number of the run that all are compared with
  std::vector<SweepTarget> targets;
  std::vector<double> times;  ///< s
};

/// The alternatives of `KEY=VALUE,VALUE,...`; commas within brackets or quotes part nothing.
/// @throws SceneError
SweepAxis parse_sweep_axis(const std::string& assignment);

/// `METRIC=VALUE`. @throws SceneError
SweepTarget parse_sweep_target(const std::string& text);

/// All runs, each read and checked. @throws SceneError for what can't be run, with its place
SweepPlan plan_sweep(const SweepRequest& request);

}  // namespace spindrift::app
