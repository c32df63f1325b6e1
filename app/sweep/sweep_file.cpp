#include "app/sweep/sweep_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <span>

#include "app/checks/scene_reader.hpp"
#include "app/errors/nearest_name.hpp"
#include "app/errors/shown_text.hpp"

namespace spindrift::app {
namespace {

constexpr std::array<std::string_view, 9> file_keys{
    "$schema", "scene", "set", "grid", "list", "latin_hypercube", "reference", "targets", "times"};
constexpr std::array<std::string_view, 3> hypercube_keys{"samples", "seed", "ranges"};
constexpr std::array<std::string_view, 4> range_keys{"min", "max", "scale", "whole"};
constexpr std::array<std::string_view, 2> scales{"linear", "logarithmic"};

/// Reads a sweep, and gathers all that is wrong with it.
class SweepReader {
 public:
  explicit SweepReader(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// @throws SceneError
  SweepRequest read(const LocatedValue& root) {
    SweepRequest request;
    if (check_keys(root, file_keys))
      read_keys(root, request);
    throw_if_any(std::move(problems_));
    return request;
  }

 private:
  void read_keys(const LocatedValue& root, SweepRequest& request) {
    if (const auto scene = root.find("scene"))
      request.scene = folder_ / text(*scene);
    else
      complain(root,
               "\"scene\" is missing (the scene file, its path from the sweep file's folder)");
    if (const auto fixed = root.find("set"))
      for (const SweepValue& value : row_of(*fixed))
        request.axes.push_back({{value}});
    if (const auto grid = root.find("grid"))
      read_grid(*grid, request.axes);
    if (const auto rows = root.find("list"))
      request.axes.push_back(read_list(*rows));
    if (const auto hypercube = root.find("latin_hypercube"))
      if (check_keys(*hypercube, hypercube_keys))
        request.axes.push_back(read_hypercube(*hypercube));
    if (const auto reference = root.find("reference"))
      request.reference = text(*reference);
    if (const auto targets = root.find("targets"))
      for_each_member(*targets, [&](const std::string& metric, const LocatedValue& value) {
        request.targets.push_back({metric, number(value)});
      });
    if (const auto times = root.find("times"))
      for_each_entry(*times,
                     [&](const LocatedValue& time) { request.times.push_back(number(time)); });
  }

  void complain(const LocatedValue& value, std::string message) {
    problems_.push_back(value.problem(std::move(message)));
  }

  void expected(const char* what, const LocatedValue& found) {
    complain(found,
             fmt::format("expected {}, found {}", what,
                         shown(found.json().dump(-1, ' ', false, Json::error_handler_t::replace))));
  }

  bool is_object(const LocatedValue& value) {
    if (!value.json().is_object())
      expected("an object {...}", value);
    return value.json().is_object();
  }

  template <class F>
  void for_each_member(const LocatedValue& value, F f) {
    if (is_object(value))
      value.for_each_member(f);
  }

  template <class F>
  void for_each_entry(const LocatedValue& value, F f) {
    if (!value.json().is_array() || value.json().empty())
      return expected("a list [...] of at least one entry", value);
    for (std::size_t k = 0; k < value.json().size(); ++k)
      f(value[k]);
  }

  std::string text(const LocatedValue& value) {
    if (!value.json().is_string()) {
      expected("text", value);
      return {};
    }
    return value.json().get<std::string>();
  }

  double number(const LocatedValue& value) {
    if (!value.json().is_number()) {
      expected("a number", value);
      return 0;
    }
    return value.json().get<double>();
  }

  int whole_number(const LocatedValue& value, int min, int max) {
    const double found = number(value);
    if (!value.json().is_number() ||
        (min <= found && found <= max && found == static_cast<int>(found)))
      return static_cast<int>(found);
    complain(value, fmt::format("{} is out of range; accepted: whole numbers, {} ... {}",
                                value.json().dump(), min, max));
    return min;
  }

  /// Whether it is an object.
  bool check_keys(const LocatedValue& value, std::span<const std::string_view> keys) {
    for_each_member(value, [&](const std::string& key, const LocatedValue& member) {
      if (std::find(keys.begin(), keys.end(), key) == keys.end())
        complain(member, fmt::format("unknown key; {}", suggestion(key, keys)));
    });
    return value.json().is_object();
  }

  /// Whether all of them are there.
  bool has(const LocatedValue& value, std::initializer_list<const char*> keys) {
    bool all = true;
    for (const char* key : keys)
      if (!value.json().contains(key)) {
        complain(value, fmt::format("\"{}\" is missing", key));
        all = false;
      }
    return all;
  }

  static SweepValue value_of(const std::string& key, const LocatedValue& value) {
    const Problem here = value.problem({});
    return {key, value.json(), fmt::format("{}: {}", here.place.text(), here.path)};
  }

  /// {"fluid.viscosity": 0.1, ...}
  SweepValues row_of(const LocatedValue& value) {
    SweepValues row;
    for_each_member(value, [&](const std::string& key, const LocatedValue& member) {
      row.push_back(value_of(key, member));
    });
    return row;
  }

  void read_grid(const LocatedValue& grid, std::vector<SweepAxis>& axes) {
    for_each_member(grid, [&](const std::string& key, const LocatedValue& values) {
      SweepAxis axis;
      for_each_entry(values,
                     [&](const LocatedValue& value) { axis.push_back({value_of(key, value)}); });
      axes.push_back(std::move(axis));
    });
  }

  SweepAxis read_list(const LocatedValue& rows) {
    SweepAxis axis;
    for_each_entry(rows, [&](const LocatedValue& row) { axis.push_back(row_of(row)); });
    return axis;
  }

  SampledRange read_range(const std::string& key, const LocatedValue& value) {
    SampledRange range{.key = key, .place = value_of(key, value).place};
    if (!check_keys(value, range_keys) || !has(value, {"min", "max"}))
      return range;
    const LocatedValue min = *value.find("min"), max = *value.find("max");
    range.min = number(min);
    range.max = number(max);
    if (min.json().is_number() && max.json().is_number() && range.min >= range.max)
      complain(max, "must be above min");
    if (const auto whole = value.find("whole")) {
      if (!whole->json().is_boolean())
        expected("true or false", *whole);
      range.whole = whole->json() == true;
    }
    if (range.whole)
      for (const LocatedValue& end : {min, max})
        whole_number(end, -1'000'000, 1'000'000);
    if (const auto scale = value.find("scale"))
      read_scale(*scale, range);
    return range;
  }

  void read_scale(const LocatedValue& value, SampledRange& range) {
    const std::string scale = text(value);
    if (value.json().is_string() && std::find(scales.begin(), scales.end(), scale) == scales.end())
      complain(value,
               fmt::format("unknown value \"{}\"; {}", shown(scale), suggestion(scale, scales)));
    range.logarithmic = scale == "logarithmic";
    if (range.logarithmic && (range.min <= 0 || range.whole))
      complain(value, "logarithmic needs a min above 0, and numbers that need not be whole");
  }

  SweepAxis read_hypercube(const LocatedValue& value) {
    if (!has(value, {"samples", "ranges"}))
      return {};
    const int samples = whole_number(*value.find("samples"), 2, 10'000);
    int seed = 1;
    if (const auto given = value.find("seed"))
      seed = whole_number(*given, 0, 2'000'000'000);
    std::vector<SampledRange> ranges;
    for_each_member(*value.find("ranges"), [&](const std::string& key, const LocatedValue& range) {
      ranges.push_back(read_range(key, range));
    });
    return problems_.empty() ? latin_hypercube(ranges, samples, static_cast<unsigned>(seed))
                             : SweepAxis{};
  }

  std::filesystem::path folder_;
  std::vector<Problem> problems_;
};

/// No scene has any of these keys.
bool is_sweep(const Json& root) {
  return root.is_object() && (root.contains("scene") || root.contains("grid") ||
                              root.contains("list") || root.contains("latin_hypercube"));
}

/// {"KEY": VALUE, ...} with values of one kind.
Json object_of(const char* about, const Json& values) {
  return {{"description", about}, {"type", "object"}, {"additionalProperties", values}};
}

Json hypercube_schema() {
  const Json number{{"type", "number"}};
  Json range{{"type", "object"},
             {"properties",
              {{"min", number},
               {"max", number},
               {"scale",
                {{"description", "in what the parts of the range are equal"},
                 {"enum", scales},
                 {"default", "linear"}}},
               {"whole",
                {{"description", "whole numbers only"}, {"type", "boolean"}, {"default", false}}}}},
             {"required", Json::array({"min", "max"})},
             {"additionalProperties", false}};
  return {{"description", "values drawn so that each part of each range is met once"},
          {"type", "object"},
          {"properties",
           {{"samples", {{"type", "integer"}, {"minimum", 2}, {"maximum", 10'000}}},
            {"seed", {{"type", "integer"}, {"minimum", 0}, {"default", 1}}},
            {"ranges", object_of("by key of the scene", range)}}},
          {"required", Json::array({"samples", "ranges"})},
          {"additionalProperties", false}};
}

}  // namespace

std::optional<SweepRequest> read_sweep_file(const std::filesystem::path& file) {
  const SceneDocument document(scene_text(file), file.string());
  if (!is_sweep(document.root()))
    return std::nullopt;
  return SweepReader(file.parent_path()).read(document.value());
}

nlohmann::ordered_json sweep_schema() {
  const Json number{{"type", "number"}};
  Json properties{
      {"$schema", {{"type", "string"}}},
      {"scene",
       {{"description", "scene file; its path from the sweep file's folder"}, {"type", "string"}}},
      {"set", object_of("values of all runs, by key, as in \"video.duration\": 2", Json::object())},
      {"grid", object_of("lists of values by key; every combination runs",
                         {{"type", "array"}, {"minItems", 1}})},
      {"list",
       {{"description", "one run for each entry"},
        {"type", "array"},
        {"minItems", 1},
        {"items", object_of("values by key", Json::object())}}},
      {"latin_hypercube", hypercube_schema()},
      {"reference",
       {{"description", "the run that all are compared with: its name, or values of it alone"},
        {"type", "string"}}},
      {"targets",
       object_of("values of figures that runs are ranked by their closeness to", number)},
      {"times",
       {{"description", "of the pictures that are set side by side (s); five if left out"},
        {"type", "array"},
        {"minItems", 1},
        {"items", {{"type", "number"}, {"minimum", 0}}}}}};
  return {{"$schema", "http://json-schema.org/draft-07/schema#"},
          {"title", "Spindrift sweep"},
          {"description",
           "A scene, and what of it is varied. Keys are those of scene files, as in "
           "fluid.viscosity or fluid.volumes[0].velocity."},
          {"type", "object"},
          {"properties", properties},
          {"required", Json::array({"scene"})},
          {"additionalProperties", false}};
}

}  // namespace spindrift::app
