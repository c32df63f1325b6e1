// The plan of a sweep: one run for every combination of the values it was given.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/scene.hpp"
#include "app/tables/document.hpp"
#include "app/tables/table.hpp"

namespace spindrift::app {

/// A key of a scene, such as fluid.viscosity, and the value that it is to have.
using SweepValue = Keyed<Json>;
using SweepValues = std::vector<SweepValue>;

/// Alternatives of which each run takes one: values of one key, or rows of values of several keys.
using SweepAxis = std::vector<SweepValues>;

/// The name of a metric, and the value that the runs' figures are to come close to.
using SweepTarget = Keyed<double>;

/// A sweep as the command line or a sweep file asks for it.
struct SweepRequest {
  std::filesystem::path scene = {};
  std::vector<SweepAxis> axes = {};  ///< an axis with one alternative is for all runs
  std::string reference = {};        ///< a run's name, or values that only one run has; empty: none
  std::vector<SweepTarget> targets = {};
  std::vector<double> times = {};  ///< times of the pictures set side by side, s; empty: five times
};

/// One run of a sweep.
struct SweepRun {
  std::string name;        ///< name of its folder, made of its values
  SweepValues values;      ///< values of the keys that vary
  Scene scene;             ///< the scene with all its values
  std::string simulation;  ///< name of the simulation's folder; runs with the same name share it
};

/// All runs of a sweep, and how they are held against each other.
struct SweepPlan {
  std::filesystem::path scene_file;
  std::vector<std::string> keys;  ///< keys of the scene that vary
  std::vector<SweepRun> runs;
  std::optional<std::size_t> reference;  ///< index of the run that all are compared with
  std::vector<SweepTarget> targets;
  std::vector<double> times;  ///< times of the pictures set side by side, s
};

/// Reads the alternatives of `KEY=VALUE,VALUE,...`. Commas within brackets or quotes belong to a
/// value.
/// @throws SceneError for a text that has no such form
SweepAxis parse_sweep_axis(const std::string& assignment);

/// Reads a target of the form `METRIC=NUMBER`.
/// @throws SceneError for a text that has no such form
SweepTarget parse_sweep_target(const std::string& text);

/// Makes the plan of a sweep, and reads and checks the scene of each run.
/// @throws SceneError with all problems of the scenes, each with its place; and for values that
/// make too many runs or none that differ, and for a reference or times that no run has
SweepPlan plan_sweep(const SweepRequest& request);

}  // namespace spindrift::app
