// Which runs a sweep has: every combination of the values it was given.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/scene/scene.hpp"
#include "app/tables/document.hpp"

namespace spindrift::app {

/// A scene's key, such as fluid.viscosity, and what it is to be.
struct SweepValue {
  std::string key;
  Json value;
  std::string place;  ///< where it was written, for messages
};
using SweepValues = std::vector<SweepValue>;

/// Alternatives, of which each run takes one: the values of one key, or rows of several keys.
using SweepAxis = std::vector<SweepValues>;

/// A figure of a run that is to come close to a value.
struct SweepTarget {
  std::string metric;
  double value = 0;
};

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

/// `count` values of one key within a range, one in each of `count` equal parts of it.
struct SampledRange {
  std::string key;
  double min = 0, max = 0;
  bool logarithmic = false;  ///< the parts are equal in the logarithm
  bool whole = false;        ///< whole numbers only
  std::string place = {};    ///< for messages
};

/// A Latin hypercube (McKay, Beckman, Conover 1979): of every key, each part of its range is met
/// once. The same seed gives the same samples everywhere.
SweepAxis latin_hypercube(const std::vector<SampledRange>& ranges, int samples, unsigned seed);

/// All runs, each read and checked. @throws SceneError for what can't be run, with its place
SweepPlan plan_sweep(const SweepRequest& request);

}  // namespace spindrift::app
